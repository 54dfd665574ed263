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
sed -n 's|.*"file": "\(.*\)".*|\1|p' build/compile_commands.json | grep -v "^$PWD/\(build/\)\?tests/" | sort -u |
  xargs -P "$(nproc)" -n 1 clang-tidy-14 -p build --quiet --warnings-as-errors='*' >"$log" 2>&1 || { grep -v -E '^[0-9]+ warnings|^Suppressed|^Use -' "$log" >&2; exit 1; }
