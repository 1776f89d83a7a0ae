# Flags shared by every target. -Wrestrict is off: GCC 12 sees overlaps in std::string that are not there. Floating-point contraction is off: C++ twins of shaders must round
# like them, on every compiler.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
# A header costs more than the file that includes it: files of a target are compiled in groups.
# Targets whose files are plug-ins or tables that use one name each for its own are not.
option(SHADOWBENCH_UNITY "Compile files of a target in groups" ON)
set(CMAKE_UNITY_BUILD ${SHADOWBENCH_UNITY})
set(CMAKE_UNITY_BUILD_BATCH_SIZE 6)
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
