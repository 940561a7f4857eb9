# SPDX-License-Identifier: Apache-2.0
# What a Debian package has otherwise than `cmake --install`: run by CPack on the files that it has gathered.
set(root ${CPACK_TEMPORARY_DIRECTORY}/usr)
set(doc ${root}/share/doc/nugget)

function(papers kind file)
  execute_process(COMMAND ${CPACK_NUGGET_PAPERS} ${kind} ${ARGN} OUTPUT_FILE ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE ${doc}/LICENSE)  # Debian has the text once for all, in common-licenses
papers(copyright ${doc}/copyright)
papers(changelog ${doc}/changelog ${CPACK_DEBIAN_PACKAGE_MAINTAINER})
execute_process(COMMAND gzip -9n ${doc}/changelog COMMAND_ERROR_IS_FATAL ANY)
papers(sbom ${doc}/nugget.spdx.json)
file(COPY ${doc}/nugget.spdx.json DESTINATION ${CPACK_PACKAGE_DIRECTORY})  # beside the package, too
file(REMOVE_RECURSE ${root}/share/zsh/vendor-completions)
file(RENAME ${root}/share/zsh/site-functions ${root}/share/zsh/vendor-completions)  # where Debian's zsh looks
