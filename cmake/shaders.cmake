# shadowbench_shaders(TARGET FOLDER SYMBOL): compiles every GLSL file below FOLDER to SPIR-V and
# OpenGL GLSL at build time and embeds the result in the object library TARGET, which defines
# `void SYMBOL(rhi::ShaderLibrary&)`.
function(shadowbench_shaders target folder symbol)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.glsl ${folder}/*.h)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND shader_compiler --root ${folder} --symbol ${symbol} --output ${output}
    DEPENDS shader_compiler ${sources}
    COMMENT "Compiling shaders of ${folder}"
    VERBATIM)
  add_library(${target} OBJECT ${output})
  target_link_libraries(${target} PUBLIC rhi)
endfunction()
