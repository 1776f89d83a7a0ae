# The report's page in headless Chromium. Debian's own Python, for python3-selenium is of it.
find_program(DEBIAN_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(NOT DEBIAN_PYTHON)
  set(DEBIAN_PYTHON ${Python3_EXECUTABLE})
endif()
add_test(NAME report.page
  COMMAND ${DEBIAN_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/page_test.py $<TARGET_FILE:bench>
    ${CMAKE_BINARY_DIR}/report-screenshots)
set_tests_properties(report.page PROPERTIES ENVIRONMENT PYTHONDONTWRITEBYTECODE=1
  SKIP_RETURN_CODE 77 TIMEOUT 180)
