#!/usr/bin/env bash
# Installs and tries the packages as a person would, in a root that has nothing else (tools/packages.sh).
# Everything but the installation is done by an ordinary user.  The last line is
# "N passed, N failed".
set -uo pipefail

. "$(dirname "$0")/check.sh"

# person COMMANDS: does them as an ordinary user, in the home folder.
person() { su - person -c "set -e; $1"; }

export DEBIAN_FRONTEND=noninteractive
check 'the lists of Debian are read' apt-get update -q
check 'the packages are installed' apt-get install -y -q /packages/*.deb
useradd --create-home --shell /bin/bash person

every_package_has_a_licence() {
  local package
  for package in $(dpkg-query -W -f '${Package}\n' '*openr-host*'); do
    grep -q 'MIT License' "/usr/share/doc/$package/copyright" || { echo "$package has none"; return 1; }
  done
}

# The commands are run as they are printed.
new_object() {
  person 'openr new Greeter >printed; cat printed; sed -n "/^\(openr\|cmake\|ctest\)/p" printed >commands
    [ $(wc -l <commands) -ge 6 ]; set -x; . ./commands'
}

hello() {
  person 'cp -r /usr/share/doc/openr-host/examples .; openr build examples/Hello
    openr run --stick examples/Hello/MS --for 1s --rate max --no-panel 2>&1 | tee said
    grep "Hello, world" said'
}

# links FILE...: whether each file that the documents link to is there.
links() {
  local file folder target bad=0
  for file in "$@"; do
    folder=$(dirname "$file")
    for target in $(grep -oE '\[[^][]+\]\([^)#: ]+[)#]' "$file" | sed 's/^.*](//; s/.$//'); do
      [ -e "$folder/$target" ] || { echo "$file links to $target"; bad=1; }
    done
  done
  return $bad
}

links_of_all_documents() {
  local files
  mapfile -t files < <(find /usr/share/doc/openr-host -name '*.md')
  [ ${#files[@]} -gt 100 ] && links "${files[@]}"
}

panel() {
  person 'openr run --panel --for 2s >said 2>&1; cat said; grep -q "http://127.0.0.1" said'
}

# client_listing LANGUAGE: the block of this language in "From C++" of the remote control's page.
client_listing() {
  sed -n '/^## From C++/,/^## Example/p' /usr/share/doc/openr-host/docs/remote-control.md |
    sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" | sed '/^```/d'
}

# A CMake project that knows nothing of openr-host but what the documents say.  Only the port is
# another one, because the root shares the network of this computer.
remote_client() {
  local folder=/home/person/client
  mkdir -p $folder
  client_listing cpp >$folder/client.cc
  client_listing cmake >$folder/CMakeLists.txt
  chown -R person: $folder
  person 'openr run --no-panel --rc-port 0 --for 120s >run.txt 2>&1 & run=$!
    until grep "remote control: " run.txt; do kill -0 $run; sleep 0.1; done
    port=$(sed -n "s/.*remote control: .*:\([0-9]*\) .*/\1/p" run.txt)
    sed -i "s/:54000/:$port/" client/client.cc
    cmake -S client -B client/build && cmake --build client/build
    # The robot refuses to move before it stands, 12 s after the start.
    for i in $(seq 60); do client/build/client >said 2>&1 && break; sleep 1; done
    kill $run; cat said; tail -n 1 said | grep "neck_pan [23]"'
}

python_module() {
  person 'cat >dog.py <<END
import openr_host
with openr_host.Run() as run:
    run.until_standing()
    copy = run.fork()
    copy.set_joints({"neck_pan": 20}, in_s=0.2)
    copy.run(1)
    turned = copy.joints()["neck_pan"]
    copy.close()
    print(openr_host.__file__, run.value("height_mm"), turned)
    assert openr_host.__file__.startswith("/usr/lib/python3") and abs(turned - 20) < 2
END
    python3 dog.py'
}

python_example() {
  person 'python3 /usr/share/doc/openr-host/examples/python/find_walk.py -o walk --generations 1 --population 2 \
      --at-least 0
    cat walk/walk.json; head -c 4 walk/GO.MTN | grep OMTN'
}

removed() {
  apt-get remove -y -q openr-host openr-host-dev openr-host-doc python3-openr-host || return 1
  ! find /usr -path '*openr*' -print | grep . &&
    [ ! -e /usr/bin/stubgen2 ]
}

check 'the program starts' person 'openr version && openr --help'
check 'the dog stands' person 'openr run --for 20s --rate max --json --no-panel 2>err | grep "\"standing\": *true"'
check 'a new object is built, run and tested, as openr new says' new_object
check 'make builds it, by way of pkg-config' person 'pkg-config --modversion openr-host
  make -C Greeter install OPENRSDK_ROOT=$(pkg-config --variable=sdk openr-host)'
check 'openr check finds nothing wrong with it' person 'openr check Greeter'
check 'an example is built and runs' hello
check 'a controller is built and runs' person 'openr controller new wag; openr controller build wag
  openr run --stick wag --for 2s --rate max --no-panel'
check 'a picture is drawn' person 'openr run --for 1s --rate max --no-panel --snapshot t=end,view=iso -o p.png
  [ -s p.png ]'
check 'a chart is drawn' person 'openr mtn plot /usr/share/openr-host/stick/OPEN-R/MW/DATA/P/WALK.MTN -o c.svg
  [ -s c.svg ]'
check 'objects run in processes of their own' person 'openr run --stick examples/Hello/MS --isolate hello \
  --for 1s --rate max --no-panel 2>&1 | grep "Hello, world"'
check 'the panel is served' panel
check 'a client of the remote control is built, as the documents say, and moves the head' remote_client
check 'Python drives a run' python_module
check 'the search for a walk runs from the examples' python_example
check 'there are manual pages' test -s /usr/share/man/man1/openr-run.1.gz
check 'bash completes commands' bash -c '. /usr/share/bash-completion/completions/openr
  COMP_WORDS=(openr ru) COMP_CWORD=1; _openr; [ "${COMPREPLY[*]}" = run ]'
check 'every package has a licence' every_package_has_a_licence
check 'links of all documents lead on' links_of_all_documents
check 'removed, nothing is left' removed

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
