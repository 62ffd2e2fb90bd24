"""For catkin alone, which installs the Python module by it."""
from setuptools import setup

from catkin_pkg.python_setup import generate_distutils_setup

packages = ['synthetic_dataset', *(f'synthetic_dataset.{each}' for each in ('pages', 'report', 'trial'))]
setup(**generate_distutils_setup(packages=packages, package_dir={'': 'python'},
                                 package_data={each: ['*.html', '*.css'] for each in packages}))
