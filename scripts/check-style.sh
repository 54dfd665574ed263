#!/bin/sh
# Style checks with pinned tools: format, include direction between folders, clang-tidy. Needs build/compile_commands.json.
set -eu
cd "$(dirname "$0")/.."
sources=$(git ls-files '*.h' '*.cpp')
echo "format (clang-format 14)"
# shellcheck disable=SC2086  # a list of words
clang-format-14 --dry-run -Werror $sources
echo "include direction"
scripts/check-includes.sh
echo "clang-tidy 14"
# shellcheck disable=SC2046
git ls-files 'base/*.cpp' 'brdf/*.cpp' 'mesh/*.cpp' 'lrcs/*.cpp' 'view/*.cpp' 'cli/*.cpp' |
  xargs -P "$(nproc)" -n 4 clang-tidy-14 -p build --quiet --warnings-as-errors='*' 2>/dev/null
