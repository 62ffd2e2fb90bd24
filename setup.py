"""For catkin alone, which installs the Python module by it."""
from setuptools import setup

from catkin_pkg.python_setup import generate_distutils_setup

setup(**generate_distutils_setup(
    packages=['synthetic_dataset', 'synthetic_dataset.report', 'synthetic_dataset.trial'], package_dir={'': 'python'},
    package_data={each: ['page.html', 'page.css'] for each in ('synthetic_dataset.report', 'synthetic_dataset.trial')}))
