#!/usr/bin/env bash
# Checks the format, the includes between folders, and other rules that a compiler does not check.
# Prints every offence with its rule.  The last line is "N passed, N failed", counted in rules.
set -uo pipefail
shopt -s lastpipe  # runs rule() at the end of a pipe in this shell, where its counters are
cd "$(dirname "${BASH_SOURCE[0]}")/.."

passed=0
failed=0

# rule NAME: reads offences from standard input; the rule passes if there are none.
rule() {
  local offences
  offences=$(cat)
  if [ -z "$offences" ]; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf '%s:\n%s\n' "$1" "$offences"
  fi
}

# rule_of NAME COMMAND...: the rule passes if the command prints nothing and does not fail.
rule_of() {
  local name=$1 offences
  shift
  offences=$("$@") || [ -n "$offences" ] || offences="$* has failed"
  printf '%s' "$offences" | rule "$name"
}

# files PATTERN FOLDER...: lists the files below the folders whose suffix matches, sorted.
files() {
  local pattern=$1
  shift
  find "$@" -regextype posix-extended -type f -regex ".*\.($pattern)" 2>/dev/null | sort
}

# grep_in REGEX FOLDER...: lists the matching lines of C and C++, except // comments.
grep_in() {
  local regex=$1
  shift
  files 'cc|c|h' "$@" | xargs -r grep -nE "$regex" /dev/null | grep -vE '^[^:]+:[0-9]+: *//'
}

if command -v clang-format >/dev/null; then
  files 'cc|h' cli kit openr runtime virtualrobot distribution testing tools tests bench | grep -vE '^(tests/(images|kit/fixtures)|bench/Sink)/' |
    xargs -r clang-format --dry-run 2>&1 | grep -E 'warning|error' | head -40 |
    rule 'clang-format (./.clang-format) would change'
else
  echo 'clang-format is not installed' | rule 'clang-format'
fi

rule_of 'includes between folders go one way (tools/layers.py)' python3 tools/layers.py
grep_in '#include *["<](dds/|ddsc/|openr_(wire|status)\.h|distribution/wire\.h)' \
  cli kit openr runtime virtualrobot objects testing tools |
  rule 'only distribution/ includes Cyclone DDS'
grep_in '#include *["<](cli|kit|openr|virtualrobot|runtime|distribution|dds|fmt|Eigen|nlohmann|ode|boost|sys|netinet|arpa|unistd|pthread|dlfcn)' \
  objects examples | rule 'objects/ and examples/ include SDK headers, the C and C++ library and their own'
grep_in '^ *# *(if|ifdef|ifndef|elif) .*(__linux|__unix|OPENR_HOST|HOST_BUILD|__x86_64|__GLIBC__)' objects examples |
  rule 'objects/ and examples/ have no special case for the host'
grep_in '(^|[^a-z])weak([^a-z]|$)' objects |
  rule 'objects/ has no weak symbols: an undefined one is not null in an image of the robot'
# Only the models (virtualrobot/model) may have the primitive names of a robot; our tables are made of
# them.  Excepted: a controller for the ERS-210, and the text of a new controller.
grep_in '"PRM:/[^"]*-' cli kit openr runtime virtualrobot distribution objects testing tools |
  grep -vE '^(objects/Controller/ers210/|kit/new_controller\.cc)|^[^:]+:[0-9]+:( *\*|.*//.*"PRM)' |
  rule 'robot constants are in virtualrobot/model only'
files 'cc|h|c' cli kit openr runtime virtualrobot distribution objects testing tools | grep -v '^virtualrobot/ode/' |
  xargs -r grep -nE '#include *[<"]ode/' /dev/null | rule 'only virtualrobot/ode includes ODE'
grep_in '#include *["<]libwebsockets' cli kit openr runtime virtualrobot distribution objects testing tools |
  grep -v '^openr/panel/web_loop\.cc:' | rule 'only openr/panel/web_loop.cc includes libwebsockets'
grep_in '#include *["<]cairo' cli kit openr runtime virtualrobot distribution objects testing tools |
  grep -v '^openr/chart/draw_chart\.cc:' | rule 'only openr/chart/draw_chart.cc includes Cairo'
# Excepted: process_hooks.cc and refused_hooks.cc define these calls for objects, wall_clock.cc is for pacing and time
# limits, and runtime/ipstack/host_*.cc reads real sockets, whose data enter at frame boundaries.
grep_in '(steady_clock|system_clock|gettimeofday|clock_gettime|random_device|std::(thread|mutex|async)|pthread_create)' \
  runtime virtualrobot | grep -vE '^runtime/(hooks/(process|refused)_hooks|ipstack/host_|base/wall_clock)' |
  rule 'no wall clock, no threads, no raw randomness in runtime/ and virtualrobot/'
grep_in '(^|[^a-zA-Z_])(v?fork|posix_spawnp?|popen) *\(' cli kit openr runtime virtualrobot distribution testing |
  grep -vE '^(cli/process_copy|runtime/base/program_start)\.cc:' |
  rule 'only cli/process_copy.cc copies this process, and only runtime/base/program_start.cc starts programs'
grep_in 'unordered_(map|set|multi)' runtime virtualrobot distribution |
  rule 'no hash order in runtime/, virtualrobot/ and distribution/'
rule_of 'a comment does not begin with who, whose, what, which, that, those, of, one, there or it (CONTRIBUTING.md)' \
  python3 tools/comments.py
# Names of a first version that only its authors understood; docs/architecture.md has the words for them.
grep_in '\b(Seat|Pulse|Courier|Knock|Elder|Tend|PutAway|EndYouth|young_|Lent|LoseOther|Fleet)\b' \
  cli kit openr runtime virtualrobot distribution objects testing |
  rule 'no coined names: the words of the glossary in docs/architecture.md'
grep_in '\b(TODO|FIXME|XXX|HACK)\b' cli kit openr runtime virtualrobot distribution objects examples testing tools tests |
  rule 'no unfinished marks'
grep -rnIE '(^|[^a-zA-Z.])/(tmp|work|root|home)/' --include='*.cc' --include='*.h' --include='*.c' \
  --include='*.cmake' --include='CMakeLists.txt' --include='*.sh' --include='*.py' --include='*.md' \
  . 2>/dev/null | grep -vE '^\./(build|\.git|tests|panel/node_modules)/' | grep -v 'tools/check.sh' |
  rule 'no paths of one machine'
files 'cc|h|c|idl|py|sh' cli kit openr runtime virtualrobot distribution objects examples testing tools tests bench | xargs -r wc -l |
  awk '$2 != "total" && $1 > 500' | rule 'no file has more than 500 lines'

rule_of 'objects/ and examples/ use what the robot has (tools/sdk_surface.py)' python3 tools/sdk_surface.py
rule_of 'docs/conformance.md is made of tests/conformance/statements.tsv' \
  python3 tools/conformance_table.py --check
rule_of 'citations of docs/openr and docs/report.md lead to a place that exists (tools/citations.py)' \
  python3 tools/citations.py
rule_of 'commits that can still be changed have a short subject and are not large (tools/commits.py)' \
  python3 tools/commits.py
# paths FILE...: lists the sources that documents name in backticks, as FILE:LINE:PATH.
paths() {
  grep -noE '`(runtime|virtualrobot|distribution|cli|kit|openr|testing|objects|tools|tests|bench)/[A-Za-z0-9_./-]+\.(h|cc|py|sh|idl)`' "$@" |
    tr -d '`'
}
paths README.md CONTRIBUTING.md docs/*.md docs/*/*.md | while IFS=: read -r file line path; do
  [ -e "$path" ] || echo "$file:$line: $path"
done | rule 'sources that documents name exist'

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
