/* SPDX-License-Identifier: Apache-2.0
   The viewer's script as bytes of the program; page_data.cpp hands them on. */
.section .rodata
.global nugget_viewer_begin
.global nugget_viewer_end
nugget_viewer_begin:
.incbin NUGGET_VIEWER_FILE
nugget_viewer_end:
.byte 0
.section .note.GNU-stack, "", @progbits
