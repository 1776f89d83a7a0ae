# shadowbench_shaders(TARGET FOLDER SYMBOL): compiles every GLSL file below FOLDER to SPIR-V and
# OpenGL GLSL at build time and embeds the result in the object library TARGET, which defines
# `void SYMBOL::addTo(rhi::ShaderLibrary&)`. A fourth argument names a folder whose files may be
# included, after those of FOLDER, but are not compiled.
function(shadowbench_shaders target folder symbol)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.glsl ${folder}/*.h)
  set(include)
  if(ARGC GREATER 3)
    file(GLOB_RECURSE included CONFIGURE_DEPENDS ${ARGV3}/*.glsl ${ARGV3}/*.h)
    list(APPEND sources ${included})
    set(include --include ${ARGV3})
  endif()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  add_custom_command(
    OUTPUT ${output} ${output}.blob
    COMMAND shader_compiler --root ${folder} --symbol ${symbol} --output ${output} ${include}
    DEPENDS shader_compiler ${sources}
    COMMENT "Compiling shaders of ${folder}"
    VERBATIM)
  add_library(${target} OBJECT ${output})
  set_source_files_properties(${output} PROPERTIES OBJECT_DEPENDS ${output}.blob)
  # ccache cannot see what .incbin reads.
  set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "")
  target_link_libraries(${target} PUBLIC shader_blob)
endfunction()
