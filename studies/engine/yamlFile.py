# SPDX-License-Identifier: GPL-3.0-or-later
"""YAML in which 40e-6 is a number, and on, off, yes and no are words, as OpenFOAM means them."""
import re

import yaml

from badInput import BadInput

NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


class Loader(yaml.SafeLoader):
    yaml_implicit_resolvers = {}  # of YAML 1.1 none are kept

    def construct_mapping(self, node, deep=False):
        keys = [key.value for key, _ in node.value]
        for key in keys:
            if keys.count(key) > 1:
                raise yaml.constructor.ConstructorError(
                    None, None, f"the key '{key}' stands there twice", node.start_mark)
        return super().construct_mapping(node, deep)


Loader.add_implicit_resolver("!number", NUMBER, list("-+.0123456789"))
Loader.add_implicit_resolver("tag:yaml.org,2002:null", re.compile(r"(~|null|)$"), ["~", "n", ""])
Loader.add_constructor("!number", lambda loader, node: number(node.value))


def number(text):
    """Whole ones as int, so that 1.0, 1 and 1e0 are the same."""
    value = float(text)
    return int(value) if value.is_integer() and abs(value) < 1e15 else value


def read(path):
    try:
        content = yaml.load(path.read_text(), Loader)
    except OSError as reason:
        raise BadInput(f"The file {path} cannot be read: {reason.strerror}.")
    except UnicodeDecodeError:
        raise BadInput(f"The file {path} cannot be read: it is no text.")
    except yaml.YAMLError as reason:
        mark = getattr(reason, "problem_mark", None)
        where = f", line {mark.line + 1}" if mark else ""
        what = getattr(reason, "problem", None) or str(reason)
        raise BadInput(f"{path.name}{where}: this is no YAML, {what}.")
    if not isinstance(content, dict):
        raise BadInput(f"{path.name}: it must hold keys with values, as 'title: ...', and does not.")
    return content
