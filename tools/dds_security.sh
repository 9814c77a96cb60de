#!/usr/bin/env bash
# Makes settings for --dds-config with which the processes of a run accept only each other, and
# encrypt their messages (DDS Security, docs/distribution.md).
#
#   dds_security.sh DIR NAME...
#
# Makes DIR/NAME.xml for each name, such as the name of a host.  The file has a certificate, signed by
# the authority in DIR (made at the first call), and its key: give NAME.xml only to NAME.  With
# DIR/ca.key anybody can admit more processes, so keep it secret.
set -euo pipefail
umask 077

if [ $# -lt 2 ]; then
  echo "usage: $0 DIR NAME..." >&2
  exit 2
fi
folder=$1
shift
mkdir -p "$folder"
cd "$folder"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
days=3650

# plugins: prints the folder of the security plugins: that of libddsc.so, or one in it (Debian).
# Debian's PATH of users other than root has no folder with ldconfig.
plugins() {
  local library
  library=$(PATH=$PATH:/usr/sbin:/sbin ldconfig -p | awk '/libddsc\.so/ { print $NF; exit }')
  [ -n "$library" ] || return 0
  find "$(dirname "$library")" -maxdepth 2 -name libdds_security_auth.so -printf '%h/\n' -quit
}
where=$(plugins)

key() { openssl genpkey -quiet -algorithm EC -pkeyopt ec_paramgen_curve:prime256v1 -out "$1"; }

if [ ! -e ca.key ]; then
  # The key comes last, so that an authority that was not finished is made anew.
  key "$scratch/ca.key"
  openssl req -x509 -new -key "$scratch/ca.key" -out ca.pem -days "$days" -subj "/CN=openr"
  mv "$scratch/ca.key" ca.key
fi

# embedded FILE: prints the file as the text of an XML element.
embedded() {
  printf 'data:,'
  sed 's/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g' "$1"
}

# signed FILE: signs the file with the key of the authority, and prints it as embedded() does.
signed() {
  openssl smime -sign -text -in "$1" -out "$1.signed" -signer ca.pem -inkey ca.key
  embedded "$1.signed"
}

domains='<domains><id_range><min>0</min><max>230</max></id_range></domains>'

cat > "$scratch/governance" <<END
<?xml version="1.0" encoding="UTF-8"?>
<dds>
  <domain_access_rules>
    <domain_rule>
      $domains
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
      <rtps_protection_kind>ENCRYPT</rtps_protection_kind>
      <topic_access_rules>
        <topic_rule>
          <topic_expression>*</topic_expression>
          <enable_discovery_protection>true</enable_discovery_protection>
          <enable_liveliness_protection>true</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>NONE</metadata_protection_kind>
          <data_protection_kind>NONE</data_protection_kind>
        </topic_rule>
      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
END

permissions() {
  local all='<topics><topic>openr_*</topic><topic>rt/*</topic></topics><partitions><partition>*</partition></partitions>'
  cat <<END
<?xml version="1.0" encoding="UTF-8"?>
<dds>
  <permissions>
    <grant name="$1">
      <subject_name>CN=$1</subject_name>
      <validity>
        <not_before>$(date -u -d '-1 day' +%FT%T)</not_before>
        <not_after>$(date -u -d "+$days days" +%FT%T)</not_after>
      </validity>
      <allow_rule>
        $domains
        <publish>$all</publish>
        <subscribe>$all</subscribe>
      </allow_rule>
      <default>DENY</default>
    </grant>
  </permissions>
</dds>
END
}

# library NAME FUNCTION: prints the XML element that loads a plugin.
library() {
  printf '<Library path="%s" initFunction="init_%s" finalizeFunction="finalize_%s"/>' \
    "${where:+${where}lib}dds_security_$1${where:+.so}" "$2" "$2"
}

settings() {
  local name=$1
  key "$scratch/key"
  openssl req -new -key "$scratch/key" -out "$scratch/request" -subj "/CN=$name"
  openssl x509 -req -in "$scratch/request" -CA ca.pem -CAkey ca.key -CAserial "$scratch/serial" \
    -CAcreateserial -days "$days" -out "$scratch/certificate" 2> "$scratch/said" ||
    { cat "$scratch/said" >&2; exit 1; }
  permissions "$name" > "$scratch/permissions"
  cat <<END
<CycloneDDS>
  <Domain id="any">
    <Security>
      <Authentication>
        $(library auth authentication)
        <IdentityCA>$(embedded ca.pem)</IdentityCA>
        <IdentityCertificate>$(embedded "$scratch/certificate")</IdentityCertificate>
        <PrivateKey>$(embedded "$scratch/key")</PrivateKey>
      </Authentication>
      <AccessControl>
        $(library ac access_control)
        <PermissionsCA>$(embedded ca.pem)</PermissionsCA>
        <Governance>$(signed "$scratch/governance")</Governance>
        <Permissions>$(signed "$scratch/permissions")</Permissions>
      </AccessControl>
      <Cryptographic>
        $(library crypto crypto)
      </Cryptographic>
    </Security>
  </Domain>
</CycloneDDS>
END
}

for name in "$@"; do
  if [[ ! $name =~ ^[A-Za-z0-9_.-]+$ ]]; then
    echo "$0: '$name': letters, digits, _ . and - only" >&2
    exit 2
  fi
  settings "$name" > "$scratch/settings"
  mv "$scratch/settings" "$name.xml"
done
