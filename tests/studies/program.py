# SPDX-License-Identifier: GPL-3.0-or-later
"""A command of the studies as a module; it makes the modules of its engine known."""
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader


def loaded(path):
    loader = SourceFileLoader(path.name, str(path))
    module = module_from_spec(spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module
