// The way of every text to the terminal: what files and drivers say cannot act there.
#pragma once

#include <string>
#include <string_view>

namespace sb {

/// "bench: TEXT" on standard error, one line of at most 300 characters.
void say(std::string_view text);
/// The same however long: what a run will do.
void note(std::string_view text);
/// Lines on standard output.
void print(std::string_view text);
/// Whether all that was printed has arrived: false on a full device or a closed pipe.
bool printed();

}  // namespace sb
