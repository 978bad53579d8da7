"""Records which tests in Python are left out. skips.mjs and skips.sh do the same for JavaScript and the shell."""
import os


def skip(what, reason):
    """Says that something is not tested, and why.

    The file that PLATEAU_SKIPS names gets the line `WHAT: REASON`. `what` is a key without numbers and paths, which
    tests/allowed-skips.txt can hold.
    """
    print(f"SKIPPED: {what}: {reason}", flush=True)
    if os.environ.get("PLATEAU_SKIPS"):
        with open(os.environ["PLATEAU_SKIPS"], "a", encoding="utf-8") as file:
            file.write(f"{what}: {reason}\n")
