# The tracer needs no driver; that techniques agree with it does.
target_sources(unit_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/area_sampling_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/area_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/integrated_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/coplanar_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/media_field_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/media_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/rays_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/stopping_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/texture_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/truth_cache_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/truth_surfaces_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/truth_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/walks_test.cpp)
target_sources(gpu_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/one_sided_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/truth_gpu_test.cpp)
target_compile_definitions(gpu_tests PRIVATE
  SHADOWBENCH_SHARED_SCENES="${SHADOWBENCH_SHARED_SCENES}"
  SHADOWBENCH_TEST_SCENES="${CMAKE_CURRENT_LIST_DIR}/../scenes/files")
