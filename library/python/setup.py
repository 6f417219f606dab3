"""pip install --no-build-isolation library/python: the extension module is built by the project's own build."""
import pathlib
import shutil
import subprocess

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = pathlib.Path(__file__).resolve().parents[2]


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        subprocess.run([PROJECT / "setup" / "build.sh", "release", "mwt_python"], check=True)
        (built,) = (PROJECT / "build" / "release" / "python" / "mwt").glob("_mwt*.so")
        target = pathlib.Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(built, target)


setup(ext_modules=[Extension("mwt._mwt", sources=[])], cmdclass={"build_ext": BuildByCMake})
