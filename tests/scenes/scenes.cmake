# Tests of optics and suites/scenes. Scenes made by others lie beside the repository, if at all.
set(SHADOWBENCH_SHARED_SCENES ${CMAKE_SOURCE_DIR}/../shared/scenes CACHE PATH
  "Scenes made by others; tests that use them say so when they are not there")
target_sources(unit_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/analysis_media_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/analysis_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/export_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/free_views_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_animation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_broken_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_choices_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_forms_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_limits_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_media_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gltf_posed_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/moving_world_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/optics_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/penumbra_bound_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/procedural_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/scene_edit_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/shared_scenes_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/tangents_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/transform_test.cpp)
find_package(ZLIB REQUIRED)
target_link_libraries(unit_tests PRIVATE
  scenes draco::draco meshoptimizer::meshoptimizer PkgConfig::webp ZLIB::ZLIB)
target_compile_definitions(unit_tests PRIVATE
  SHADOWBENCH_SHARED_SCENES="${SHADOWBENCH_SHARED_SCENES}")
