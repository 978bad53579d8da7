# Records which tests in the shell are left out, to be sourced. skips.mjs and skips.py do the same for JavaScript and Python.

# Says that something is not tested, and why. The file that PLATEAU_SKIPS names gets the line `WHAT: REASON`. WHAT is a key
# without numbers and paths, which tests/allowed-skips.txt can hold.
skipped() { # WHAT REASON
  printf 'SKIPPED: %s: %s\n' "$1" "$2"
  [ -z "${PLATEAU_SKIPS-}" ] || printf '%s: %s\n' "$1" "$2" >>"$PLATEAU_SKIPS"
}
