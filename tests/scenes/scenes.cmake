# Tests of optics and suites/scenes. Scenes made by others lie beside the repository, if at all.
set(SHADOWBENCH_SHARED_SCENES ${CMAKE_SOURCE_DIR}/../shared/scenes CACHE PATH
  "Scenes made by others; tests that use them say so when they are not there")
target_sources(unit_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/shared_scenes_test.cpp)
target_link_libraries(unit_tests PRIVATE scenes)
target_compile_definitions(unit_tests PRIVATE
  SHADOWBENCH_SHARED_SCENES="${SHADOWBENCH_SHARED_SCENES}")
