"""Figures of a benchmark: printed as tables while they come, and kept as JSON beside the processor that they were measured on."""

import datetime
import json
import pathlib
import re


def processor():
    found = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return found[1] if found else "unknown"


class Report:
    """add_to(parser) gives a script the option --json FILE; Report(o.json) is what it then fills."""

    @staticmethod
    def add_to(parser):
        parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="where the figures are kept, too")

    def __init__(self, file):
        self.file = file
        self.kept = {"processor": processor(), "date": datetime.date.today().isoformat(), "tables": {}}

    def table(self, name, columns):
        """columns: what stands above each, and how its values are written (None: as they are). Returns what takes the values of a row; None is written -."""
        rows = self.kept["tables"][name] = []
        print("| " + " | ".join(columns) + " |\n|---|" + "--:|" * (len(columns) - 1))

        def add(*values):
            rows.append(dict(zip(columns, values)))
            print("| " + " | ".join("-" if v is None else format(v, f or "") for v, f in zip(values, columns.values())) + " |", flush=True)
            if self.file:
                self.file.write_text(json.dumps(self.kept, indent=1) + "\n")
        return add
