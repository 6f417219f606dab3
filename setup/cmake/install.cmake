# What cmake --install copies besides the library (library/library.cmake): the programs, and what they bring. The manual pages and
# completions are printed by the program itself, each time that it is built.
install(TARGETS mwt mwt_verify RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)

set(documents ${PROJECT_BINARY_DIR}/documents)
add_custom_command(TARGET mwt POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E make_directory ${documents}
  COMMAND mwt manual > ${documents}/mwt.1
  COMMAND mwt manual mwt_verify > ${documents}/mwt_verify.1
  COMMAND gzip -9nf ${documents}/mwt.1 ${documents}/mwt_verify.1
  COMMAND mwt completion bash > ${documents}/mwt
  COMMAND ${CMAKE_COMMAND} -E create_symlink mwt ${documents}/mwt_verify
  COMMAND mwt completion zsh > ${documents}/_mwt
  COMMENT "Printing manual pages and completions" VERBATIM)
install(FILES ${documents}/mwt.1.gz ${documents}/mwt_verify.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${documents}/mwt ${documents}/mwt_verify DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        COMPONENT program)
install(FILES ${documents}/_mwt DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)

# Studies and the programs that they name, in the folders that they have here: studies name these by relative paths.
set(shared_folder ${CMAKE_INSTALL_DATADIR}/mwt)
install(DIRECTORY harness/studies DESTINATION ${shared_folder}/harness COMPONENT program PATTERN "*.cpp" EXCLUDE)
install(DIRECTORY library/examples/rivals DESTINATION ${shared_folder}/library/examples COMPONENT program
        USE_SOURCE_PERMISSIONS PATTERN "__pycache__" EXCLUDE)
# What draws figures and pages: mwt report calls it.
install(DIRECTORY plots DESTINATION ${shared_folder} COMPONENT program USE_SOURCE_PERMISSIONS PATTERN "__pycache__" EXCLUDE
        PATTERN "testdata" EXCLUDE PATTERN "*_test.py" EXCLUDE PATTERN "page_testing.py" EXCLUDE PATTERN "browser.py" EXCLUDE
        PATTERN "make_tour.py" EXCLUDE)
