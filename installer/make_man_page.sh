#!/usr/bin/env bash
# make_man_page.sh PROGRAM SUMMARY: prints the man page of PROGRAM, made from what its --help says, and that of each of
# its subcommands. Deterministic: no date.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
[ "$#" -eq 2 ] || { echo "usage: make_man_page.sh PROGRAM SUMMARY" >&2; exit 1; }
program="$1" summary="$2"
name="$(basename -- "${program}")"
version="$("${program}" --version | awk '{ print $NF }')"

# Turns CLI11's help on standard input into roff: usage, then lists; a subcommand's first line is a paragraph.
as_roff() {
  awk '
    function roff(text) {
      gsub(/\\/, "\\e", text); gsub(/-/, "\\-", text); sub(/^[.'\'']/, "\\\\\\&&", text)
      return text
    }
    # An entry: two spaces, what is typed, then the text from the 31st column or on the next line.
    function entry(line,   typed, text) {
      typed = substr(line, 3); text = ""
      if (match(typed, /  +/)) { text = substr(typed, RSTART + RLENGTH); typed = substr(typed, 1, RSTART - 1) }
      print ".TP"; print "\\fB" roff(typed) "\\fR"
      if (text != "") print roff(text)
    }
    /^Usage: / { print ".PP"; print "\\fB" roff(substr($0, 8)) "\\fR"; next }
    /^[A-Z][A-Za-z ]*:$/ { print ".PP"; print "\\fI" roff(substr($0, 1, length($0) - 1)) "\\fR"; next }
    /^   / { sub(/^ +/, ""); print roff($0); next }
    /^  / { entry($0); next }
    /^$/ { next }
    { print ".PP"; print roff($0) }
  '
}

cat <<PAGE
.\\" Made by make_man_page.sh from ${name} --help.
.TH ${name^^} 1 "" "Footfall ${version}" "User Commands"
.SH NAME
${name} \\- ${summary}
.SH DESCRIPTION
PAGE
help="$("${program}" --help)"
as_roff <<<"${help}"
mapfile -t commands < <(awk '/^Subcommands:/ { on = 1; next } on && /^  [a-z]/ { print $1 }' <<<"${help}")
for command in "${commands[@]}"; do
  printf '.SH %s %s\n' "${name^^}" "${command^^}"
  "${program}" "${command}" --help | as_roff
done
cat <<'PAGE'
.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
the run failed or was cancelled
.TP
.B 2
the command line or the input is not right; one line on standard error says what and where
PAGE
if [ "${name}" = footfall ]; then other=footfall-editor; else other=footfall; fi
printf '.SH SEE ALSO\n.BR %s (1)\n' "${other//-/\\-}"
