#!/usr/bin/python3
"""Runs what the pages tell the reader to type.

Of README.md every ```sh and ```bash block is run, of docs/**/*.md those that say `sh run`. Blocks share a copy-free
workspace and run in order, each in a shell of its own that stops at the first error (set -e) and starts at the root of
the workspace. A block is left out only if its first line is the comment
    # set-up          it installs packages, or clones the repository
    # tests           it calls `make test`, as the one who runs this test already does
A line `# exit 3` (any number) as first line says which exit code the block ends with instead of 0.
"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
LIMIT = 900     # [s] for one block
LEFT_OUT = ("# set-up", "# tests")
FENCE = re.compile(r"^(?P<indent> *)```(?P<info>[^\n`]*)\n(?P<body>.*?)^(?P=indent)```[ \t]*$", re.MULTILINE | re.DOTALL)


class Block:
    def __init__(self, path, line, text):
        self.where, self.text = "%s:%d" % (path, line), text
        first = text.split("\n", 1)[0].strip()
        self.left_out = first in LEFT_OUT
        expected = re.match(r"# exit (\d+)$", first)
        self.expected = int(expected.group(1)) if expected else 0


def blocks(root, path):
    """The runnable blocks of one page."""
    with open(os.path.join(root, path), encoding="utf-8") as file:
        page = file.read()
    always = os.path.basename(path) == "README.md" and os.path.dirname(path) == ""
    for fence in FENCE.finditer(page):
        words = fence.group("info").split()
        if words[:1] in (["sh"], ["bash"]) and (always or "run" in words[1:]):
            indent = fence.group("indent")
            body = "".join(l[len(indent):] if l.startswith(indent) else l for l in fence.group("body").splitlines(True))
            body = re.sub(r"^\$ ", "", body, flags=re.MULTILINE)
            yield Block(path, page.count("\n", 0, fence.start()) + 2, body)


def pages(root):
    found = ["README.md"] if os.path.exists(os.path.join(root, "README.md")) else []
    for folder, _, names in sorted(os.walk(os.path.join(root, "docs"))):
        found += [os.path.relpath(os.path.join(folder, n), root) for n in sorted(names) if n.endswith(".md")]
    return found


def run(root, block, limit=LIMIT):
    """None if the block did what it should, else what happened."""
    env = {k: v for k, v in os.environ.items()
           if k not in ("CMAKE_PREFIX_PATH", "ROS_PACKAGE_PATH", "ROS_MASTER_URI", "PYTHONPATH", "LD_LIBRARY_PATH",
                        "MAKEFLAGS", "MAKELEVEL", "MFLAGS")}     # as in the reader's fresh shell
    with tempfile.TemporaryFile("w+", errors="replace") as output:
        process = subprocess.Popen(["/bin/bash", "-e", "-o", "pipefail", "-c", block.text], cwd=root, env=env,
                                   stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        try:
            code = process.wait(limit)
        except subprocess.TimeoutExpired:
            code = "no end after %g s" % limit
        finally:
            try:
                os.killpg(process.pid, signal.SIGKILL)      # what the block left in the background
            except ProcessLookupError:
                pass
            process.wait()
        if code == block.expected:
            return None
        output.seek(0)
        return "%s: exit %s instead of %d from\n%s\nwhich said\n%s" % (block.where, code, block.expected, block.text,
                                                                       output.read()[-4000:])


class Pages(unittest.TestCase):
    def test_every_block_runs(self):
        self.assertIn("README.md", pages(ROOT), "there is no README.md")
        readme = list(blocks(ROOT, "README.md"))
        self.assertTrue([b for b in readme if not b.left_out], "README.md shows no command")
        for page in pages(ROOT):
            for block in blocks(ROOT, page):
                if not block.left_out:
                    with self.subTest(block.where):
                        problem = run(ROOT, block)
                        self.assertIsNone(problem, problem)

    def test_relative_links_lead_somewhere(self):
        links = [(page, target) for page in pages(ROOT)
                 for target in re.findall(r"\]\(([^)#]+)[^)]*\)", pathlib.Path(ROOT, page).read_text(encoding="utf-8"))
                 if "://" not in target]
        self.assertTrue(links)
        missing = ["%s: %s" % link for link in links
                   if not os.path.exists(os.path.join(ROOT, os.path.dirname(link[0]), link[1]))]
        self.assertEqual(missing, [])

    def test_only_setup_and_tests_are_left_out(self):
        allowed = {"# set-up": r"(sudo |apt-get |apt |git clone |cd |scripts/setup|make\b.*\bsetup|export |#|$)",
                   "# tests": r"(make test\b|\.ci/run|#|$)"}
        for page in pages(ROOT):
            for block in blocks(ROOT, page):
                if block.left_out:
                    lines = block.text.splitlines()
                    for line in lines[1:]:
                        self.assertRegex(line, "^" + allowed[lines[0].strip()],
                                         "%s: left out as `%s`, but runs something else" % (block.where, lines[0]))


class Reader(unittest.TestCase):
    def read(self, text, name="README.md"):
        with tempfile.TemporaryDirectory() as root:
            path = os.path.join(root, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w") as file:
                file.write(text)
            self.assertEqual(pages(root), [name])
            return [(b.where, b.left_out, b.expected, run(root, b, 5)) for b in blocks(root, name)]

    def test_finds_blocks(self):
        found = self.read("a\n```sh\ntrue\n```\n```\nfalse\n```\n```python\nfalse\n```\n- b\n\n  ```bash\n  $ true\n  ```\n")
        self.assertEqual(found, [("README.md:3", False, 0, None), ("README.md:14", False, 0, None)])

    def test_other_pages_choose(self):
        found = self.read("```sh\nfalse\n```\n```sh run\ntrue\n```\n", "docs/a/b.md")
        self.assertEqual(found, [("docs/a/b.md:5", False, 0, None)])

    def test_any_failing_line_fails(self):
        for text in ("false\ntrue", "false | cat", "exit 7", "# exit 3\ntrue", "nosuchcommand", "kill -9 $$"):
            (_, _, _, problem), = self.read("```sh\n%s\n```\n" % text)
            self.assertIn("README.md:2", problem or "", text)
            self.assertIn(text, problem)

    def test_expected_exit_code_and_left_out_blocks(self):
        self.assertIsNone(self.read("```sh\n# exit 3\nexit 3\n```\n")[0][3])
        self.assertTrue(self.read("```sh\n# set-up\nfalse\n```\n")[0][1])

    def test_a_hanging_block_ends(self):
        with tempfile.TemporaryDirectory() as root:
            self.assertIn("no end after", run(root, Block("README.md", 1, "sleep 60"), limit=0.2))


if __name__ == "__main__":
    if sys.argv[1:] == ["--list"]:
        for page in pages(ROOT):
            for block in blocks(ROOT, page):
                print("%s%s\n%s" % (block.where, " (left out)" if block.left_out else "", block.text))
        sys.exit(0)
    unittest.main()
