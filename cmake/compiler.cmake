# Flags shared by every target. -Wrestrict is off: GCC 12 sees overlaps in std::string that are not there. Floating-point contraction is off: C++ twins of shaders must round
# like them, on every compiler.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
find_program(MOLD mold)
if(MOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_link_options(-fuse-ld=mold)
endif()

add_compile_options(-Wall -Wextra -Wno-missing-field-initializers -Wno-restrict -ffp-contract=off)
if(SHADOWBENCH_WERROR)
  add_compile_options(-Werror)
endif()
if(SHADOWBENCH_SANITIZE)
  # No vptr: glslang is built without run-time type information, and refuses to link with it.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize=vptr -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
include_directories(${CMAKE_SOURCE_DIR})
