#include "Messages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <mutex>

namespace
{
class MessageKeeper : public vtkOutputWindow
{
public:
  static MessageKeeper* New();

  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayGenericWarningText(const char* text) override { this->KeepWarning(text); }
  void DisplayWarningText(const char* text) override { this->KeepWarning(text); }
  void DisplayErrorText(const char* text) override { this->Keep(text, this->Error); }

  std::string Get(const std::string& kept)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    return kept;
  }

  void Clear()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Error.clear();
    this->Warning.clear();
  }

  std::string Error;
  std::string Warning;

private:
  void Keep(const std::string& text, std::string& kept)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (kept.empty())
    {
      kept = text;
    }
  }

  // Legacy, STL and PLY readers only warn when a file ends too early, and go on.
  void KeepWarning(const std::string& text)
  {
    const bool failedToRead = text.find("rror reading") != std::string::npos;
    this->Keep(text, failedToRead ? this->Error : this->Warning);
  }

  std::mutex Mutex; // filters report from their threads
};
vtkStandardNewMacro(MessageKeeper);

MessageKeeper* Keeper()
{
  static const vtkSmartPointer<MessageKeeper> keeper = vtkSmartPointer<MessageKeeper>::New();
  return keeper;
}

// The text alone, without what VTK puts around it.
std::string OneLine(std::string text)
{
  if (text.empty())
  {
    return text;
  }
  // "ERROR: In FILE, line N\nCLASS (ADDRESS): TEXT\n\n"
  if (const std::size_t head = text.find(", line "); head != std::string::npos)
  {
    text.erase(0, std::min(text.find('\n', head), text.size() - 1) + 1);
  }
  if (const std::size_t address = text.find("): "); address != std::string::npos)
  {
    text.erase(0, address + 3);
  }
  text.erase(0, text.find_first_not_of(" \n"));
  text.erase(std::min(text.find('\n'), text.size()));
  // What a broken file holds may end up in the message: a terminal must survive it.
  for (char& character : text)
  {
    if (static_cast<unsigned char>(character) < 0x20 ||
      static_cast<unsigned char>(character) > 0x7e)
    {
      character = '?';
    }
  }
  if (text.empty())
  {
    return "no reason given";
  }
  const std::size_t longest = 160;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}
}

void CatchMessages()
{
  vtkOutputWindow::SetInstance(Keeper());
  // The logger prints beside the output window.
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

void ClearMessages()
{
  Keeper()->Clear();
}

std::string FirstError()
{
  return OneLine(Keeper()->Get(Keeper()->Error));
}

std::string FirstWarning()
{
  return OneLine(Keeper()->Get(Keeper()->Warning));
}
