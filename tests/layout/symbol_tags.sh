#!/bin/sh
# SPDX-FileCopyrightText: 2026 the silt authors
# SPDX-License-Identifier: MIT
# symbol_tags.sh LEVEL OBJECT…: fails where an object that is compiled for one instruction set, which
# xsimd calls LEVEL (sse2, avx2, avx512f), holds a function that the linker may take in place of
# another object's of the same name: one whose name does not have xsimd::LEVEL in it, or has that of
# another of the three. Fails too where there is nothing to look at.
level=$1
shift
[ $# -gt 0 ] || { echo "no objects were given"; exit 1; }
symbols=$(nm -C --defined-only "$@") || { echo "nm failed"; exit 1; }
shared=$(printf '%s\n' "$symbols" | grep -E ' [VWu] ' | grep -v ' DW\.ref\.')
tag="xsimd::$level([^a-z0-9_]|\$)"
others=$(printf '%s\n' sse2 avx2 avx512f | grep -vx "$level" | paste -sd '|')
wrong=$(printf '%s\n' "$shared" |
  awk -v tag="$tag" -v other="xsimd::($others)([^a-z0-9_]|\$)" '$0 != "" && ($0 !~ tag || $0 ~ other)')
if [ -n "$wrong" ]; then
  echo "without $level, or with another instruction set, in their names:"
  echo "$wrong"
  exit 1
fi
[ -n "$shared" ] || { echo "nothing of $level in these objects"; exit 1; }
