# cmake -DBENCH=... -DOUT=... -P bundle.cmake
# Copies the program and every shared library it needs into OUT, except glibc (2.36 or newer is
# expected) and the GPU's drivers and loaders, which belong to the machine; then packs OUT.tar.gz.
# Libraries that drivers need as well are used only where the system has none (bundle_start.sh).
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT}/lib)
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${BENCH}
  RESOLVED_DEPENDENCIES_VAR libraries UNRESOLVED_DEPENDENCIES_VAR missing
  PRE_EXCLUDE_REGEXES "^ld-linux" "^lib(c|m|dl|rt|pthread|vulkan|EGL|GL|OSMesa)\\.so")
if(missing)
  message(FATAL_ERROR "libraries not found: ${missing}")
endif()
file(COPY ${BENCH} DESTINATION ${OUT}/bin)
configure_file(${CMAKE_CURRENT_LIST_DIR}/bundle_start.sh ${OUT}/bench COPYONLY)
# What a device is asked on one short visit (tests/device/README.md).
set(tests ${CMAKE_CURRENT_LIST_DIR}/../tests)
file(COPY ${tests}/device/check.sh DESTINATION ${OUT})
file(COPY ${tests}/fuzz/corpus/lights.gltf ${tests}/fuzz/corpus/textured.gltf
  DESTINATION ${OUT}/scenes)
foreach(library ${libraries})
  get_filename_component(name ${library} NAME)
  set(folder lib)
  if(name MATCHES "^lib(stdc\\+\\+|gcc_s|z)\\.so")
    set(folder lib/fallback/${name})
  endif()
  file(COPY ${library} DESTINATION ${OUT}/${folder} FOLLOW_SYMLINK_CHAIN)
endforeach()
get_filename_component(parent ${OUT} DIRECTORY)
get_filename_component(name ${OUT} NAME)
execute_process(COMMAND ${CMAKE_COMMAND} -E tar czf ${OUT}.tar.gz ${name}
  WORKING_DIRECTORY ${parent} COMMAND_ERROR_IS_FATAL ANY)
message(STATUS "bundle: ${OUT}.tar.gz")
