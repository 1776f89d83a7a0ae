# Hard cases at their small sizes.
target_sources(gpu_tests PRIVATE ${CMAKE_CURRENT_LIST_DIR}/stability_test.cpp)
target_link_libraries(gpu_tests PRIVATE stability)
# What of them needs no driver.
target_sources(unit_tests PRIVATE ${CMAKE_CURRENT_LIST_DIR}/stability_faults_test.cpp)
target_link_libraries(unit_tests PRIVATE stability)
