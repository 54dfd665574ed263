#!/bin/sh
# Style checks with pinned tools: format, include direction between folders, clang-tidy. Needs build/compile_commands.json.
set -eu
cd "$(dirname "$0")/.."
echo "format (clang-format 14)"
git ls-files '*.h' '*.cpp' | xargs clang-format-14 --dry-run -Werror
echo "include direction"
scripts/check-includes.sh
echo "clang-tidy 14"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
# Sources are read as they are built, several as one unit, but written out: the analyser looks at nothing included.
mkdir -p build/style
sed 's|_cxx\.cxx\([" ]\)|_cxx.whole.cpp\1|g' build/compile_commands.json >build/style/compile_commands.json
sed -n 's|.*"file": "\(.*\)".*|\1|p' build/style/compile_commands.json | grep -v "^$PWD/\(build/\)\?tests/" | sort -u >build/style/files
sed '/\.whole\.cpp$/d' build/style/files >build/style/read
sed -n '/\.whole\.cpp$/p' build/style/files | while read -r unit; do
  sed -n 's|#include "\(.*\)"|\1|p' "${unit%.whole.cpp}.cxx" | tee -a build/style/read | xargs cat >"$unit"
done
# Every source must be among them, by itself or within a unit.
sort -o build/style/read build/style/read
git ls-files '*.cpp' | grep -v -E '^(tests|examples)/' | sed "s|^|$PWD/|" | sort | comm -23 - build/style/read >build/style/unread
[ ! -s build/style/unread ] || { echo "not read, for want of a target:" >&2; cat build/style/unread >&2; exit 1; }
xargs -P "$(nproc)" -n 1 clang-tidy-14 -p build/style --quiet --warnings-as-errors='*' <build/style/files >"$log" 2>&1 ||
  { grep -v -E '^[0-9]+ warnings|^Suppressed|^Use -' "$log" >&2; exit 1; }
