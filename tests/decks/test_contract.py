# SPDX-License-Identifier: Apache-2.0
"""docs/reference/contract.md against the program: commands, options, keys of summary.json."""
import json
import re
import unittest

from lap_joint import deck
from nugget_command import SOURCE, CommandTest

PAGE = (SOURCE / "docs" / "reference" / "contract.md").read_text(encoding="utf-8")


def section(title):
    return re.search(rf"^## {title}\n(.*?)(?=^## |\Z)", PAGE, re.M | re.S)[1]


def commands(title):
    """(command, its options) of each line of a section that shows a call."""
    for line in re.findall(r"^    (?:mpirun -n N )?nugget (.+)$", section(title), re.M):
        call = re.split(r"\s{3,}", line)[0]
        names = re.match(r"[a-z|]+(?= |$)", call)
        for name in names[0].split("|") if names else [""]:
            yield name, re.findall(r"(?<!\S)\[?(--?[a-z][a-z-]*)", call)


def missing(example, value, where="summary.json"):
    """Keys of the example that the value lacks; of lists the first elements are compared."""
    if isinstance(example, dict):
        if not isinstance(value, dict):
            return [f"{where} is no object"]
        return [m for key in example
                for m in ([f"{where}: {key}"] if key not in value else missing(example[key], value[key], f"{where}: {key}"))]
    if isinstance(example, list) and example and isinstance(example[0], dict):
        return missing(example[0], value[0], f"{where}[0]") if value else [f"{where} is empty"]
    return []


class Contract(CommandTest):
    def test_commands_and_options_are_known(self):
        seen = list(commands("The command"))
        self.assertGreater(len(seen), 10)
        helps = {}
        for name, options in seen:
            arguments = [name, "--help"] if name else ["--help"]
            text = helps.setdefault(name, self.nugget(*arguments).stdout)
            for option in options:
                with self.subTest(command=name, option=option):
                    self.assertRegex(text, rf"(?<![\w-]){option}(?![\w-])")
        for name in helps:
            if name:
                self.assertRegex(helps[""], rf"(?m)^  {name} ")

    def test_keys_of_summary_json(self):
        example = json.loads(re.search(r"```json\n(.*?)```", PAGE, re.S)[1])
        self.write(deck())
        self.nugget("run", "model.k", "-o", "run", "--max-cycles", "3")
        self.nugget("modes", "model.k", "-o", "modes", "-n", "1")
        modes = example.pop("modes")
        self.assertEqual(missing(example, self.json("run/summary.json")), [])
        self.assertEqual(missing({"modes": modes}, self.json("modes/summary.json")), [])


if __name__ == "__main__":
    unittest.main()
