#!/usr/bin/env bash
# ./dev bench [NAME]: all rows, or those whose name contains NAME; JSON in build/bench.json.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
OPENR_COMMIT=$(git describe --always --dirty 2>/dev/null || echo unknown)
export OPENR_COMMIT
exec build/release/bin/openr_bench build/release/stick "${1:-}" build/bench.json
