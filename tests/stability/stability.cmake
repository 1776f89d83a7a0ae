# Hard cases at their small sizes.
target_sources(gpu_tests PRIVATE ${CMAKE_CURRENT_LIST_DIR}/stability_test.cpp)
target_link_libraries(gpu_tests PRIVATE stability)
