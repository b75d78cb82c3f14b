"""Where an installation puts the package: Debian's interpreter must look there for the prefix that was chosen."""
import os
import pathlib
import site
import subprocess
import sys

import pytest

BUILD = pathlib.Path(os.environ["PYTHONPATH"].split(":")[0]).parent


@pytest.mark.parametrize("prefix, folder", [("/usr", "lib/python3"),
                                            ("/usr/local", f"lib/python{sys.version_info.major}.{sys.version_info.minor}")])
def test_the_package_lies_where_the_interpreter_looks(tmp_path, prefix, folder):
    subprocess.run(["cmake", "--install", BUILD, "--component", "python", "--prefix", prefix], check=True,
                   env=os.environ | {"DESTDIR": str(tmp_path)}, capture_output=True, timeout=120)
    place = f"{prefix}/{folder}/dist-packages"
    assert (tmp_path / place[1:] / "fyd" / "__init__.py").exists()
    assert place in site.getsitepackages()
