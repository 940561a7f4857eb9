# SPDX-License-Identifier: Apache-2.0
"""Completion of the command line in real shells, from the script that the program writes: commands, options, choices, files."""
import re
import shutil
import subprocess
import unittest

from nugget_command import CommandTest

BASH, ZSH = shutil.which("bash"), shutil.which("zsh")

# What zsh would list for a line: it is typed to a zsh that sits at a terminal, with Tab, and what comes is read back.
ZSH_DRIVER = r"""
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell 'PS1=; unsetopt prompt_cr prompt_sp; fpath=($1 $fpath); autoload -Uz compinit; compinit -u -d $1/dump'
zpty -w shell 'LISTMAX=0; zstyle ":completion:*" list-colors ""; zstyle ":completion:*" menu no; setopt no_auto_menu; stty columns 400'
zpty -w shell 'zstyle ":completion:*" insert-unambiguous false; compadd() { local -a found; builtin compadd -O found "$@"; print -rl -- @${^found} >>$1/seen; builtin compadd "$@" }'
zpty -w shell "cd $1/.."
zpty -n -w shell "$2"$'\t'
repeat 120; do sleep 0.25; [[ -s $1/seen ]] && { sleep 0.5; break }; done
zpty -d shell
"""


def option_names(help_text):
    """The names of the options that --help lists."""
    return {name for line in re.findall(r"^  (-\S+)", help_text, re.M) for name in re.sub(r"{.*?}", "", line).split(",")}


class Completion(CommandTest):
    def setUp(self):
        super().setUp()
        for name in ("model.k", "car.key", "b.dyn", "notes.txt", "sub/inner.k", "other/readme"):
            self.write("", name)
        self.helps = {"": self.nugget("--help").stdout}
        self.commands = re.findall(r"^  ([a-z]+) ", self.helps[""].split("Subcommands:")[1], re.M)


class KindsOfValues(Completion):
    def test_what_help_calls_a_folder_or_a_deck_is_one(self):
        """A new option or word without its row in src/app/command_text.cpp would be completed with nothing."""
        seen = []
        for command in self.commands:
            text = re.sub(r"\n {20,}", "   ", self.nugget(command, "--help").stdout)
            seen += re.findall(r"^  (\S+) ([A-Z]+)\b.*?   +(?:the )?(folder|deck)\b", text, re.M)
        self.assertGreater(len(seen), 15)
        self.assertEqual([row for row in seen if row[1] != row[2].upper()], [])


@unittest.skipUnless(BASH, "bash is not installed")
class InBash(Completion):
    def offered(self, line):
        """What bash would offer for the last word of the line, which it cuts at blanks and at `=`."""
        words = re.findall(r"=|[^\s=]+", line) + ([""] if line[-1] == " " else [])
        script = self.write(self.nugget("--completion", "bash").stdout, "completion.bash")
        text = f'source "{script}"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _nugget; printf "%s\\n" "${{COMPREPLY[@]}}"'
        run = subprocess.run([BASH, "--norc", "-c", text, "bash", *words], capture_output=True, text=True, cwd=self.folder)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return sorted(set(run.stdout.split("\n")) - {"", "completion.bash"})

    def test_commands(self):
        self.assertEqual(self.offered("nugget "), sorted({*self.commands, *option_names(self.helps[""])}))
        self.assertEqual(self.offered("nugget che"), ["check"])
        self.assertGreater(len(self.commands), 10)

    def test_every_option_of_every_command(self):
        for command in self.commands:
            with self.subTest(command=command):
                names = option_names(self.nugget(command, "--help").stdout)
                self.assertIn("--help", names)
                self.assertEqual(self.offered(f"nugget {command} -"), sorted(names))
        self.assertEqual(self.offered("nugget run model.k --weld-"), ["--weld-law", "--weld-tie"])

    def test_choices(self):
        self.assertEqual(self.offered("nugget welds other --sort "), ["energy", "failure", "margin"])
        self.assertEqual(self.offered("nugget welds other --sort=m"), ["margin"])
        self.assertEqual(self.offered("nugget modes model.k --weld-tie "), ["area", "joint"])
        self.assertEqual(self.offered("nugget weld --as solid"), ["solid", "solid16", "solid4", "solid8"])
        self.assertIn(r"mm\,\ t\,\ s", self.offered("nugget weld --units "))

    def test_decks_and_folders(self):
        decks = ["b.dyn", "car.key", "model.k", "other", "sub"]
        for line in ("nugget run ", "nugget check -j 2 ", "nugget modes --quiet ", "nugget run i="):
            with self.subTest(line=line):
                self.assertEqual(self.offered(line), decks)
        self.assertEqual(self.offered("nugget run sub/"), ["sub/inner.k"])
        for line in ("nugget run model.k -o ", "nugget run --output=", "nugget report ", "nugget report sub ", "nugget run --resume "):
            with self.subTest(line=line):
                self.assertEqual(self.offered(line), ["other", "sub"])
        self.assertEqual(self.offered("nugget run --weld-law no"), ["notes.txt"])
        self.assertEqual(self.offered("nugget run model.k another "), [])  # it takes one deck


@unittest.skipUnless(ZSH, "zsh is not installed")
class InZsh(Completion):
    def offered(self, line):
        self.write(self.nugget("--completion", "zsh").stdout, "functions/_nugget")
        driver = ZSH_DRIVER.replace("$1", str(self.folder / "functions"))
        subprocess.run([ZSH, "-f", "-c", driver, "zsh", "", line], capture_output=True, text=True, cwd=self.folder, timeout=60)
        seen = (self.folder / "functions" / "seen").read_text().splitlines()
        return {word[1:] for word in seen if word[1:]}

    def test_a_command_an_option_a_choice_a_deck(self):
        for line, wanted, unwanted in (("nugget che", {"check"}, {"run"}),
                                       ("nugget run --weld-", {"--weld-law", "--weld-tie"}, {"--quiet"}),
                                       ("nugget welds other --sort ", {"energy", "failure", "margin"}, {"other"}),
                                       ("nugget run m", {"model.k"}, {"notes.txt"})):
            with self.subTest(line=line):
                seen = self.offered(line)
                self.assertLessEqual(wanted, seen)
                self.assertFalse(unwanted & seen)
                (self.folder / "functions" / "seen").unlink()


class OtherShells(CommandTest):
    def test_other_shells_are_refused(self):
        self.assertIn("bash and zsh, not 'fish'", self.nugget("--completion", "fish", expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
