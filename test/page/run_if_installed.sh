#!/bin/sh
# Runs a command, or says that the test is skipped if its program is not installed.
if ! command -v "$1" > /dev/null; then
  echo "$1 is not installed: skipped"
  exit 77
fi
exec "$@"
