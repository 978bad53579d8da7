"""Draws requests of all kinds from named families, solves them and judges the results by code of its own.

    python3 scripts/campaign                      a minute on the service at PLATEAU_URL
    python3 scripts/campaign --long               an hour
    python3 scripts/campaign --program target/debug/plateau --families film_two_rings,strip_open
    python3 scripts/campaign --seed 7 --case fault_borromean_rings/12      prints one request

Each case has a number, and its request follows from the seed, the family and the number alone. The table at the end has a
row for each family. A wrong case is printed with the command that repeats it, and its request is written to `--keep`.
Exit status 1 if a case is wrong.
"""

import argparse
import json
import os
import sys
import time
from collections import Counter
from pathlib import Path
from random import Random

sys.path.insert(0, str(Path(__file__).parent))

import judge  # noqa: E402
from families import FAMILIES  # noqa: E402
from hosts import DEFECTS, Program, Service  # noqa: E402
from relations import RELATIONS, agree  # noqa: E402

# Share of the cases that are submitted a second time and then cancelled.
# CANCEL_SECONDS is the longest time from the cancel to the end of the job.
CANCELLED, CANCEL_SECONDS = 0.1, 1.0


def draw(seed, family, number):
    return FAMILIES[family](Random(f"{seed}/{family}/{number}"))


def judged(host, seed, family, number):
    """Solves one case and one of its relations. Returns the outcome and what is wrong, as sentences."""
    case, random = draw(seed, family, number), Random(f"{seed}/{family}/{number}/relation")
    outcome = host.solve(case.request)
    wrong = []
    if outcome.error in DEFECTS or outcome.error == "no-answer":
        wrong.append(f"{outcome.error}: {outcome.detail[:400]}")
    if outcome.succeeded:
        wrong += judge.faults(case.request, outcome.statistics, outcome.mesh, outcome.warnings)
    wrong += [sentence for check in case.checks for sentence in [check(outcome)] if sentence]
    if random.random() < CANCELLED and (took := host.cancelled(case.request, random.uniform(0, outcome.seconds))) > CANCEL_SECONDS:
        wrong.append(f"ends {took:.2f} s after it is cancelled")
    if case.relations and not wrong:
        name = random.choice(case.relations)
        other, factor = RELATIONS[name](random, case.request)
        second = host.solve(other)
        if second.error in DEFECTS or second.error == "no-answer":
            wrong.append(f"{name}: {second.error}: {second.detail[:400]}")
        elif second.succeeded:
            wrong += [f"{name}: {text}" for text in judge.faults(other, second.statistics, second.mesh, second.warnings)]
        differs = agree(name, case.request, outcome, second, factor)
        wrong += [differs] if differs else []
    return outcome, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", default=None, help="any text; by default the time")
    parser.add_argument("--seconds", type=float, default=None)
    parser.add_argument("--long", action="store_true", help="an hour in place of a minute")
    parser.add_argument("--cases", type=int, default=None, help="largest number of cases")
    parser.add_argument("--families", default=None, help="names separated by commas")
    parser.add_argument("--program", default=None, help="path of plateau, to solve without a service")
    parser.add_argument("--patience", type=float, default=60, help="seconds after which a case counts as hanging")
    parser.add_argument("--case", default=None, help="prints the request of FAMILY/NUMBER")
    parser.add_argument("--keep", default=None, help="folder for the requests of wrong cases")
    options = parser.parse_args()
    seed = options.seed or str(int(time.time()))
    if options.case:
        family, number = options.case.split("/")
        print(json.dumps(draw(seed, family, int(number)).request))
        return 0
    url = os.environ.get("PLATEAU_URL")
    if not (options.program or url):
        parser.error("set PLATEAU_URL or give --program")
    host = Program(options.program, options.patience) if options.program else Service(url, options.patience)
    names = options.families.split(",") if options.families else list(FAMILIES)
    budget = options.seconds or (3600 if options.long else 60)
    print(f"seed {seed}, {len(names)} families, budget {budget:.0f} s")
    started, rows, number, total = time.monotonic(), {name: Counter() for name in names}, 0, 0
    slowest, refused, failed = {name: 0.0 for name in names}, {}, 0
    while time.monotonic() - started < budget and (options.cases is None or total < options.cases):
        for name in names:
            if time.monotonic() - started >= budget or (options.cases is not None and total >= options.cases):
                break
            total += 1
            outcome, wrong = judged(host, seed, name, number)
            row = rows[name]
            row["cases"] += 1
            row["solved" if outcome.succeeded else "refused"] += 1
            slowest[name] = max(slowest[name], outcome.seconds)
            if not outcome.succeeded:
                kind = draw(seed, name, number).request["kind"]
                detail = next((line for line in outcome.detail.splitlines() if line.strip()), "")
                refused.setdefault((kind, outcome.error), (Counter(), detail))[0][name] += 1
            if wrong:
                row["wrong"] += 1
                failed += 1
                print(f"\nWRONG {name}/{number} (--seed {seed} --case {name}/{number})")
                for sentence in wrong[:5]:
                    print(f"  {sentence}")
                if options.keep:
                    Path(options.keep).mkdir(parents=True, exist_ok=True)
                    Path(options.keep, f"{name}_{number}.json").write_text(json.dumps(draw(seed, name, number).request))
        number += 1
    print(f"\n{'family':44} {'cases':>6} {'solved':>7} {'refused':>8} {'wrong':>6} {'slowest s':>10}")
    for name, row in rows.items():
        print(f"{name:44} {row['cases']:6} {row['solved']:7} {row['refused']:8} {row['wrong']:6} {slowest[name]:10.2f}")
    sums = sum(rows.values(), Counter())
    print(f"{'all':44} {sums['cases']:6} {sums['solved']:7} {sums['refused']:8} {sums['wrong']:6} {max(slowest.values()):10.2f}")
    print("\nrefused, by kind and error, with the first detail and the families:")
    for (kind, error), (families, detail) in sorted(refused.items()):
        print(f"  {kind} {error} {sum(families.values())}: {detail[:200]}")
        print("    " + ", ".join(f"{name} {count}" for name, count in sorted(families.items())))
    print(f"\n{total} cases in {time.monotonic() - started:.0f} s of {budget:.0f} s; {failed} wrong")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
