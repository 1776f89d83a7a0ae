# The RHI: its own rules on the null backend, and conformance of every real one.
file(GLOB rhi_gpu_tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.cpp)
set(rhi_unit_tests
  ${CMAKE_CURRENT_LIST_DIR}/ledger_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/memory_limit_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/null_backend_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/validator_draw_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/validator_fixture.cpp
  ${CMAKE_CURRENT_LIST_DIR}/validator_pass_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/validator_resource_test.cpp)
list(REMOVE_ITEM rhi_gpu_tests ${rhi_unit_tests})
target_sources(gpu_tests PRIVATE ${rhi_gpu_tests})
target_sources(unit_tests PRIVATE ${rhi_unit_tests})
