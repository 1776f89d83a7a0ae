// LP_NATIVE_VECTOR_WIDTH: the width of the code that Mesa's llvmpipe (lavapipe, OpenGL in software)
// makes. Two faults of the driver hang on it, seen with Mesa 22.3.6:
// - its shader cache on disk does not tell widths apart. Code for 256 bits writes eight vertices
//   where a process of 128 bits has room for four: the heap is corrupt. The other way round nothing
//   breaks, but the times are those of another width.
// - other values crash or hang the compiler, a width beyond the CPU's vectors among them.
#pragma once

#include <string>

namespace sb {

/// The value that the environment holds; empty: unset.
std::string vectorWidth();

/// Why the driver cannot run with this value; empty: it can.
std::string whyNoVectorWidth(const std::string& value);

/// Of a value that the driver can run with: what it does to the numbers.
std::string vectorWidthNote(const std::string& value);

/// Before any driver is loaded. With a width that works, this process neither reads nor writes
/// Mesa's shader cache; one that does not work is taken out of the environment, so that whoever
/// goes on goes on with the driver's own.
void guardVectorWidth();

}  // namespace sb
