# Conformance of resources, shaders' access to them, queries and frames.
target_sources(gpu_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/resource_helpers.cpp
  ${CMAKE_CURRENT_LIST_DIR}/convention_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/storage_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/compute_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/visibility_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/texture_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sampler_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/compare_sampler_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/query_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/draw_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/indirect_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/specialization_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/read_back_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/srgb_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/frame_test.cpp)
