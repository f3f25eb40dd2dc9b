#!/bin/sh
# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
# untagged_symbols.sh OBJECT…: fails where an object that is compiled for one instruction set holds a
# function that the linker may take in place of another object's of the same name.
untagged=$(nm -C --defined-only "$@" | grep -E ' [VWu] ' | grep -v -e 'xsimd::\(sse2\|avx2\|avx512f\)' -e 'DW\.ref\.')
[ -z "$untagged" ] && exit 0
echo "without an instruction set in their names:"
echo "$untagged"
exit 1
