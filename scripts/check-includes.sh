#!/bin/sh
# Which folder may include which (docs/architecture.md). Exit status 1 and a line for each include that goes the wrong way.
set -eu
cd "$(dirname "$0")/.."
status=0
allow() { # folder, folders it may include
  wrong=$(grep -nE '^#include "(base|brdf|measurement|fit|mesh|cad|lrcs|view|report|cli|bench)/' "$1"/*.h "$1"/*.cpp 2>/dev/null | grep -vE "#include \"($2)/" || true)
  [ -z "$wrong" ] || { echo "$wrong"; status=1; }
}
allow base 'base'
allow brdf 'base|measurement|brdf'
allow measurement 'base|measurement'
allow fit 'base|measurement|brdf|fit'
allow mesh 'base|mesh'
allow cad 'base|mesh|cad'
allow lrcs 'base|measurement|brdf|mesh|cad|lrcs'
allow view 'base|mesh|view'
allow report 'base|mesh|report'
allow cli 'base|measurement|brdf|fit|mesh|cad|lrcs|view|report|cli'
allow bench 'base|measurement|brdf|fit|mesh|cad|lrcs|view|bench'
exit $status
