#!/usr/bin/python3
"""The notebooks of examples/, run from the first cell to the last; what they claim, they assert themselves."""
import glob
import os
import shutil
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))


class Notebooks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="notebook test ")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        # Whoever runs the test keeps their own Jupyter as it is; the kernel is Debian's.
        os.environ.pop("MPLBACKEND", None)   # pictures go into the notebook
        os.environ.update(JUPYTER_RUNTIME_DIR=self.folder, JUPYTER_DATA_DIR=self.folder, JUPYTER_CONFIG_DIR=self.folder,
                          IPYTHONDIR=self.folder, TMPDIR=self.folder, QUAD_ROOT=ROOT)

    def test_every_notebook_runs(self):
        import nbformat
        from nbclient import NotebookClient

        paths = sorted(glob.glob(os.path.join(ROOT, "examples", "*.ipynb")))
        self.assertTrue(paths, "examples/ has no notebook")
        for path in paths:
            with self.subTest(os.path.basename(path)):
                notebook = nbformat.read(path, as_version=4)
                nbformat.validate(notebook)
                self.assertFalse([c for c in notebook.cells if c.get("outputs")], "committed with outputs; clear them")
                NotebookClient(notebook, timeout=120, kernel_name="python3",
                               resources={"metadata": {"path": self.folder}}).execute()
                printed = "".join(o.get("text", "") for c in notebook.cells for o in c.get("outputs", []))
                pictures = sum("image/png" in o.get("data", {}) for c in notebook.cells for o in c.get("outputs", []))
                self.assertIn("verdict: the promise was KEPT", printed)
                self.assertGreaterEqual(pictures, 2)


if __name__ == "__main__":
    unittest.main()
