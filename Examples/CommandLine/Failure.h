/**
 * What ends a command before its work is done. Both become one line on standard error:
 *
 *     smoothshadow: error: WHAT, in WHICH FILE, what to do
 */
#ifndef Failure_h
#define Failure_h

#include <stdexcept>
#include <string>

/// Bad input, or an output that cannot be made: exit code 1.
struct Failure : std::runtime_error
{
  Failure(const std::string& what, const std::string& file, const std::string& advice)
    : std::runtime_error(what + ", in " + file + ", " + advice)
  {
  }
};

/// Wrong usage, found while or after the arguments are parsed: exit code 2.
struct UsageError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

#endif
