/**
 * One line on the terminal that says what is being done. Silent where standard error is no
 * terminal.
 */
#ifndef Progress_h
#define Progress_h

#include <string>

class vtkAlgorithm;

class Progress
{
public:
  Progress();

  /// Clears the line.
  ~Progress();

  Progress(const Progress&) = delete;
  void operator=(const Progress&) = delete;

  /// A fraction below zero shows none.
  void Show(const std::string& work, double fraction = -1.0);

  /// Shows the algorithm's own progress while it runs.
  void Watch(vtkAlgorithm* algorithm, const std::string& work);

private:
  const bool Terminal;
};

#endif
