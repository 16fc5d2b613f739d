/**
 * Keeps VTK's own messages off the terminal, so that a command can put the first error into its
 * one line.
 */
#ifndef Messages_h
#define Messages_h

#include <string>

/// From here on VTK's errors and warnings are kept instead of printed.
void CatchMessages();

/// Forgets what was kept.
void ClearMessages();

/// Text of the first error since the last ClearMessages, in one line, without file, line and
/// address; empty where there was none. A reader's warning that it could not read on is an error.
std::string FirstError();

/// The same for warnings of any other kind.
std::string FirstWarning();

#endif
