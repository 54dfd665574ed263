#!/bin/sh
# Reads and diagnoses a thousand damaged files, and the FILES given, under the address and undefined-behaviour
# sanitizers: sanitize.sh [--count N] [--first-seed N] [FILES]. Builds what that takes into build-sanitized/.
# Files that fail stay in build-sanitized/mutants.
set -eu
cd "$(dirname "$0")/.."
scripts/install-deps.sh
mkdir -p build-sanitized
cmake -S . -B build-sanitized -G Ninja -DLRCS_SANITIZE=ON -DLRCS_TESTS=ON -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_FLAGS="-O1 -g1" >build-sanitized/configure.log 2>&1 ||
  { cat build-sanitized/configure.log >&2; exit 1; }
cmake --build build-sanitized -j"$(nproc)" --target lrcs_mutants
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# Readers are libraries with copies of ours in them; those of other people leak.
ASAN_OPTIONS="detect_leaks=0:detect_odr_violation=0:allocator_may_return_null=1:quarantine_size_mb=16:exitcode=99"
UBSAN_OPTIONS="print_stacktrace=1:exitcode=99"
export ASAN_OPTIONS UBSAN_OPTIONS
build-sanitized/bin/lrcs_mutants --scratch "$scratch" --keep build-sanitized/mutants "$@"
