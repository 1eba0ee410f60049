"""Reads the part of GLSL ES 3.00 that the drop-ins use into a syntax tree with types, and edits its text. Refuses GLSL
that is wrong or outside that part, with file and line."""

import re
from collections import ChainMap, namedtuple

TOKEN = re.compile(r"""
    (?P<space>(?:\s|\\\n)+) | (?P<comment>//[^\n]*|/\*.*?\*/)
    | (?P<dialect>\#if[^\n]*\ (?:GL_ES|__VERSION__)\b(?:(?!\#endif).)*\#endif\n*)
    | (?P<directive>\#(?:\\\n|(?!//|/\*)[^\n])*)
    | (?P<number>0[xX][\da-fA-F]+[uU]?|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[uUfFi]?) | (?P<name>[A-Za-z_]\w*)
    | (?P<sign><<=|>>=|&&|\|\||<<|>>|[-+*/%&|^=<>!]=|\+\+|--|[^\w\s])""", re.VERBOSE | re.DOTALL)
# Each number's or vector's type, with the type of its components and their number.
SHAPES = {kind: (kind, 1) for kind in ("float", "int", "uint", "bool")}
SHAPES |= {f"{kind[0].strip('f')}vec{size}": (kind, size) for kind in ("float", "int", "uint") for size in (2, 3, 4)}
TYPES = {shape: name for name, shape in SHAPES.items()}
SIGNS = ["||", "&&", "|", "^", "&", "== !=", "< > <= >=", "<< >>", "+ -", "* / %"]
PRECEDENCE = {sign: level for level, signs in enumerate(SIGNS, 1) for sign in signs.split()}
LOGICAL = set("|| && == != < > <= >=".split())
ASSIGNMENTS = set("= += -= *= /= %= &= |= ^= <<= >>=".split())
# GLSL's functions that have a translation. The second ones turn vectors into a number.
FUNCTIONS = """abs acos asin atan ceil clamp cos cross distance dot exp exp2 floor fract inversesqrt length log log2 max
    min mix normalize pow reflect sign sin smoothstep sqrt step tan trunc uintBitsToFloat""".split()
REDUCING = {"dot", "length", "distance"}
ARGUMENTS = {"clamp": 3, "mix": 3, "smoothstep": 3} | dict.fromkeys("min max pow step dot distance cross reflect".split(), 2)
# The arguments of functions of vectors that may be numbers, all or none of them, and functions of whole numbers, too.
NUMBERS = {"min": (1,), "max": (1,), "clamp": (1, 2), "mix": (2,), "step": (0,), "smoothstep": (0, 1)}
WHOLE = {"abs": "int", "sign": "int", "min": "int uint", "max": "int uint", "clamp": "int uint"}


class Refused(Exception):
    """A text that has no translation."""


Token = namedtuple("Token", "kind text start end line")


class Node:
    """A part of the syntax tree: its kind, place in the text, parts and, for expressions and declarations, its type."""

    changed, declared, callee = False, None, None  # changed: by an assignment, ++ or a call

    def __init__(self, kind, first, last, parts=(), type=None, **more):
        self.kind, self.start, self.end, self.line, self.type = kind, first.start, last.end, first.line, type
        self.parts = [part for part in parts if part]
        self.__dict__.update(more)

    def walk(self):
        """Returns all nodes below this one, and then this one."""
        found, rest = [], [self]
        while rest:
            found.append(rest.pop())
            rest += found[-1].parts
        return found[::-1]


def tokens(text, start=0, end=None, line=1):
    """Yields the tokens of a text, without white space."""
    while match := TOKEN.match(text, start, len(text) if end is None else end):
        if match.lastgroup != "space":
            yield Token(match.lastgroup, match[0].rstrip(), start, match.end(), line)
        start, line = match.end(), line + match[0].count("\n")


def without_comments(text):
    """Returns the text without comments and the spaces before them."""
    return re.sub(" +$", "", TOKEN.sub(lambda match: "" if match["comment"] else match[0], text), flags=re.MULTILINE)


def root(node):
    """Returns the declaration of the variable of which an expression is a part."""
    return node.declared if node.kind == "name" else root(node.parts[0])


def changes(node):
    """Returns the declarations of the variables that a part of the tree changes."""
    return {root(part) for part in node.walk() if part.changed}


def shape(type):
    """Returns the kind of a number or vector and its number of components, or the type of an array's elements and 0."""
    return (type[:-2], 0) if type and type.endswith("[]") else SHAPES.get(type, (None, 0))


class Shader:
    """The syntax tree of a drop-in. `before` is the drop-in before it, whose names it uses, and `tested` are the user's
    macros, by default all that a condition tests. Directives and comments may stand between any two tokens. All branches
    of a condition are read, one after the other."""

    def __init__(self, text, path, before=None, tested=None):
        self.text, self.path, self.before, self.items = text, path, before, []
        self.structs, self.functions, self.macros, variables = (
            dict(getattr(before, kind, {})) for kind in ("structs", "functions", "macros", "variables"))
        self.variables = ChainMap(variables)  # a map for each scope
        found = list(tokens(text))
        self.comments, self.directives, self.dialects = (
            [token for token in found if token.kind == kind] for kind in ("comment", "directive", "dialect"))
        self.tested = set(re.findall(r"^#ifn?def (\w+)", text, re.MULTILINE)) if tested is None else tested
        self.defined = [self.macro(token) for token in self.directives if token.text.startswith("#define")]
        empty = {name for name, node in self.macros.items() if not node.body}
        code = [token for token in found if token.kind in ("name", "number", "sign") and token.text not in empty]
        self.start_reading(code, text.count("\n") + 1)
        while self.token.kind != "end":
            self.items.append(self.definition())
        self.start = min(place.start for place in [*self.directives, *self.items])

    def start_reading(self, found, line):
        self.tokens, self.place = [*found, Token("end", "the end", len(self.text), len(self.text), line)], 0

    @property
    def token(self):
        return self.tokens[self.place]

    def refuse(self, reason, where=None):
        raise Refused(f"{self.path}:{(where or self.token).line}: {reason} has no translation")

    def take(self, text=None):
        """Returns the next token, which must have this text if one is given."""
        if text not in (None, self.token.text) or self.place + 1 == len(self.tokens):
            self.refuse(f"'{self.token.text}'" + (f" where {text} should be" if text else ""))
        self.place += 1
        return self.tokens[self.place - 1]

    def maybe(self, *texts):
        return self.take() if self.token.text in texts else None

    def until(self, closing, read, separator=None):
        """Reads parts up to a closing token, with separators between them."""
        parts = []
        while self.token.text != closing:
            if parts and separator:
                self.take(separator)
            parts.append(read())
        self.place += 1
        return parts

    def node(self, kind, first, parts=(), type=None, **more):
        """Returns a node from a token or node to the last token."""
        return Node(kind, first, self.tokens[self.place - 1], parts, type, **more)

    def macro(self, directive):
        """Reads a #define, whose body must be an expression."""
        _, name, *body = tokens(self.text, directive.start + 1, directive.start + len(directive.text), directive.line)
        if body and body[0].text == "(" and body[0].start == name.end:
            self.refuse(f"{name.text}, a macro with arguments,", name)
        self.start_reading(body, directive.line)
        parts = self.until("the end", self.expression)
        type = parts[0].type if parts else None
        self.macros[name.text] = Node("macro", name, [name, *body][-1], parts, type, name=name, body=body)
        return self.macros[name.text]

    def definition(self):
        """Reads a struct, constant or function."""
        first = self.token
        if first.text == "const":
            return self.declaration("variable")
        if not self.maybe("struct"):
            return self.function(first)
        name = self.take()
        self.take("{")
        parts = self.until("}", lambda: self.declaration("field"))
        self.take(";")
        fields = {field.name.text: field for line in parts for field in line.parts}
        self.structs[name.text] = self.node("struct", first, parts, name=name, fields=fields)
        return self.structs[name.text]

    def is_type(self, token):
        return token.text in {"void", *SHAPES, *self.structs}

    def type_name(self):
        return self.take() if self.is_type(self.token) else self.refuse(f"'{self.token.text}'")

    def declaration(self, kind):
        """Reads the declaration of one or more variables or fields, with a semicolon."""
        first, constant, type_name = self.token, self.maybe("const"), self.type_name()
        parts = self.until(";", lambda: self.variable(kind, type_name, constant=bool(constant)), ",")
        return self.node("declare", first, parts, constant=constant)

    def variable(self, kind, type_name, first=None, **more):
        """Reads a variable, parameter or field, after its type, and declares it."""
        name = self.take()
        length = self.until("]", self.expression) if self.maybe("[") else []
        value = self.fitting(self.whole(), type_name.text) if self.maybe("=") else None
        node = self.node(kind, first or name, [*length, value], type_name.text + "[]" * len(length),
                         name=name, type_name=type_name, value=value, **more)
        if kind == "parameter" and length:
            self.refuse("an array as a parameter", name)
        if kind != "field" and self.variables.maps[0].setdefault(name.text, node).type != node.type:
            self.refuse(f"a second {name.text} with another type", name)
        return node

    def parameter(self):
        first, words = self.token, [""]
        while word := self.maybe("const", "in", "out", "inout"):
            words.append(word.text)
        return self.variable("parameter", self.type_name(), first,
                             out=words[-1].endswith("out"), constant="const" in words)

    def function(self, first):
        type_name, name = self.type_name(), self.take()
        self.take("(")
        self.variables = self.variables.new_child()
        parameters = self.until(")", self.parameter, ",")
        node = self.node("function", first, parameters, type_name.text, name=name, parameters=parameters)
        first_one = self.functions.setdefault(name.text, node)
        if [part.type for part in first_one.parameters] != [part.type for part in parameters]:
            self.refuse(f"a second {name.text} with other parameters", first)
        self.returned = node.type
        node.body = self.block(self.take("{"))
        node.parts, node.end = [*parameters, node.body], node.body.end
        self.variables = self.variables.parents
        return node

    def block(self, first):
        """Reads statements up to a closing brace."""
        self.variables = self.variables.new_child()
        parts = self.until("}", self.statement)
        self.variables = self.variables.parents
        return self.node("block", first, parts)

    def statement(self):
        first = self.token
        if self.maybe("{"):
            return self.block(first)
        if self.maybe("if"):
            return self.condition(first)
        if self.maybe("for"):
            return self.loop(first)
        if self.maybe("while"):
            parts = [self.test(), self.statement()]
            return self.node("while", first, parts)
        if self.maybe("do"):
            parts = [self.statement(), self.take("while") and self.test()]
            self.take(";")
            return self.node("do", first, parts)
        if self.maybe("return"):
            parts = [] if self.token.text == ";" else [self.fitting(self.whole(), self.returned)]
            return self.ended("return", first, parts)
        if self.maybe("break", "continue"):
            return self.ended("jump", first)
        if self.token.text == ";":
            return self.ended("empty", first)
        if first.text == "const" or self.is_type(first) and self.tokens[self.place + 1].kind == "name":
            return self.declaration("variable")
        return self.ended("expression", first, [self.whole()])

    def ended(self, kind, first, parts=()):
        self.take(";")
        return self.node(kind, first, parts)

    def test(self):
        """Reads the condition of a statement, in parentheses."""
        self.take("(")
        node = self.fitting(self.whole(), "bool")
        self.take(")")
        return node

    def condition(self, first):
        parts = [self.test(), self.statement()]
        if self.maybe("else"):
            parts.append(self.statement())
        return self.node("if", first, parts)

    def loop(self, first):
        """Reads a for loop. Its parts are the statement before it, the test, what follows each turn, and the body."""
        self.take("(")
        self.variables = self.variables.new_child()
        begin = self.statement()
        test = None if self.token.text == ";" else self.fitting(self.whole(), "bool")
        self.take(";")
        step = self.until(")", self.whole, ",")
        body = self.statement()
        self.variables = self.variables.parents
        return self.node("for", first, [begin, test, *step, body], begin=begin, test=test, step=step, body=body)

    def whole(self):
        """Reads an expression that is no part of another one. C++ may evaluate its parts in any order."""
        node = self.expression()
        if self.token.text in ASSIGNMENTS:
            sign, value = self.take(), self.whole()
            type = node.type if sign.text == "=" else self.operation(Token("sign", sign.text[:-1], *sign[2:]), node, value)
            self.fitting(value if sign.text == "=" else Node("", node, value, type=type), node.type)
            node = self.node("assign", self.pure(node), [node, value], node.type, sign=sign)
        used = [part.declared for part in node.walk() if part.kind == "name"]
        if any(used.count(variable) > 1 for variable in changes(node)):
            self.refuse("a use and a change of a variable in one expression", node)
        if node.kind == "assign":
            self.change(node.parts[0])
        return node

    def pure(self, node):
        """Returns the expression, which must change nothing, because some languages evaluate it always, or twice."""
        if changes(node):
            self.refuse("a change within a part of an expression that may be skipped or repeated", node)
        return node

    def change(self, node):
        """Notes that an expression changes."""
        if any(part.kind == "member" and part.swizzle for part in node.walk()):
            self.refuse(f"a change of '{self.text[node.start:node.end]}'", node)
        node.changed = True
        return node

    def widest(self, nodes, where):
        """Returns the type of an operation: that of its largest vector, or None if a part's type is unknown."""
        types = [node.type for node in nodes]
        if any(type in self.structs for type in types):
            self.refuse(f"{where.text} of structs", where)
        return None if None in types else max(types, key=lambda type: shape(type)[1])

    def fitting(self, node, type):
        """Returns an expression, which must have this type, because GLSL ES converts none."""
        if node.type != type and None not in (node.type, type):
            self.refuse(f"{node.type} in the place of {type}", node)
        return node

    def operation(self, sign, left, right):
        """Returns the type of two values with a sign between them."""
        type = self.widest([left, right], sign)
        if type is None:
            return None
        (kind, size), (other, count) = shape(left.type), shape(right.type)
        if sign.text in LOGICAL and size + count != 2:
            self.refuse(f"{sign.text} of a {type}", sign)
        if sign.text in ("<<", ">>"):
            good, type = {kind, other} <= {"int", "uint"} and count in (1, size), left.type
        else:
            kinds = {"&&": "bool", "||": "bool", "==": "bool int uint float", "!=": "bool int uint float"} | dict.fromkeys("%&|^", "int uint")
            good = kind == other and kind in kinds.get(sign.text, "int uint float").split() and (size == count or 1 in (size, count))
        if not good:
            self.refuse(f"{left.type} {sign.text} {right.type}", sign)
        return "bool" if sign.text in LOGICAL else type

    def expression(self):
        test = self.binary(1)
        if not (sign := self.maybe("?")):
            return test
        self.fitting(test, "bool")
        yes, no = self.pure(self.expression()), self.take(":") and self.pure(self.expression())
        return self.node("choice", test, [test, yes, self.fitting(no, yes.type)], self.widest([yes, no], sign))

    def binary(self, level):
        left = self.unary()
        while PRECEDENCE.get(self.token.text, 0) >= level:
            sign = self.take()
            right = self.binary(PRECEDENCE[sign.text] + 1)
            if sign.text in ("&&", "||"):
                self.pure(right)
            left = self.node("binary", left, [left, right], self.operation(sign, left, right), sign=sign)
        return left

    def unary(self):
        if sign := self.maybe("-", "+", "!", "~"):
            part = self.unary()
            if part.type and shape(part.type)[0] not in {"!": "bool", "~": "int uint"}.get(sign.text, "int uint float").split():
                self.refuse(f"{sign.text} of a {part.type}", sign)
            return self.node("unary", sign, [part], part.type, sign=sign)
        if sign := self.maybe("++", "--"):
            return self.step(sign, sign, self.unary())
        node = self.primary()
        while sign := self.maybe(".", "[", "++", "--"):
            if sign.text == ".":
                node = self.member(node, self.take())
            elif sign.text == "[":
                index = self.expression()
                self.take("]")
                if index.type not in ("int", "uint") or shape(node.type)[1] == 1:
                    self.refuse(f"an index of type {index.type} into a {node.type}", index)
                node = self.node("index", node, [node, index], shape(node.type)[0])
            else:
                node = self.step(node, sign, node)
        if node.type and node.type.endswith("[]"):
            self.refuse("a whole array", node)
        return node

    def step(self, first, sign, part):
        if part.type not in ("int", "uint"):
            self.refuse(f"{sign.text} of a {part.type}", sign)
        return self.node("step", first, [self.change(part)], part.type, sign=sign)

    def member(self, part, name):
        """Returns a struct's member, or components of a vector."""
        struct = self.structs.get(part.type)
        if name.text not in struct.fields if struct else set(name.text) - set("xyzw"[:max(shape(part.type)[1], 0)]):
            self.refuse(f".{name.text} of a {part.type}", name)
        type = struct.fields[name.text].type if struct else TYPES.get((shape(part.type)[0], len(name.text)))
        return self.node("member", part, [part], type, name=name, swizzle=not struct and len(name.text) > 1)

    def primary(self):
        token = self.take()
        if token.kind == "number":
            whole = token.text[:2] in ("0x", "0X") or not set(token.text) & set(".eEfF")
            type = "uint" if token.text[-1] in "uU" else "int" if whole else "float"
            return self.node("number", token, type=type, name=token)
        if token.text == "(":
            parts = self.until(")", self.expression)
            return self.node("group", token, parts, parts[0].type)
        if token.text in ("true", "false"):
            return self.node("name", token, type="bool", name=token)
        if token.kind == "name" and self.maybe("("):
            parts = self.until(")", self.expression, ",")
            return self.called(self.node("call", token, parts, name=token))
        if declared := self.variables.get(token.text):
            return self.node("name", token, type=declared.type, name=token, declared=declared)
        if macro := self.macros.get(token.text):
            return self.node("macro_name", token, type=macro.type, name=token)
        self.refuse(f"'{token.text}'", token)

    def called(self, node):
        """Returns the call with what it calls, and its type."""
        name = node.name.text
        if name in SHAPES:
            node.what, node.type = "vector", self.constructed(node, *SHAPES[name])
        elif name in self.structs:
            node.what, node.type, node.callee = "struct", name, self.structs[name]
            self.arguments(node, node.callee.fields.values())
        elif name in self.functions:
            node.what, node.callee = "function", self.functions[name]
            node.type = node.callee.type
            self.arguments(node, node.callee.parameters)
            for part, given in zip(node.parts, node.callee.parameters):
                if given.out and self.change(part).kind != "name":
                    self.refuse(f"'{self.text[part.start:part.end]}' as an out argument", part)
        elif name in self.tested:
            node.what = "macro"
        else:
            node.what, node.type = "builtin", self.builtin(node, name)
        return node

    def arguments(self, node, wanted):
        if len(node.parts) != len(wanted):
            self.refuse_types(node)
        for part, each in zip(node.parts, wanted):
            self.fitting(part, each.type)

    def refuse_types(self, node):
        self.refuse(f"{node.name.text}({', '.join(str(part.type) for part in node.parts)})", node)

    def constructed(self, node, kind, size):
        """Returns the type of a vector or number that a call makes. Not all languages shorten or convert vectors."""
        shapes = [shape(part.type) for part in node.parts]
        mixed = len(shapes) > 1 and any(count > 1 and other != kind for other, count in shapes)
        counts = [count for _, count in shapes]
        if mixed or 0 not in counts and sum(counts) != size and counts != [1]:
            self.refuse_types(node)
        return node.name.text

    def builtin(self, node, name):
        """Returns the type of a call of one of GLSL's functions."""
        if name not in FUNCTIONS:
            self.refuse(name, node)
        if len(node.parts) not in ((1, 2) if name == "atan" else (ARGUMENTS.get(name, 1),)):
            self.refuse_types(node)
        kind, size = shape(self.widest(node.parts, node.name))
        kinds = {shape(part.type)[0] for part in node.parts}
        sizes = [shape(part.type)[1] for part in node.parts]
        numbers = {sizes[i] for i in NUMBERS.get(name, ())}
        others = {count for i, count in enumerate(sizes) if i not in NUMBERS.get(name, ())}
        wanted = "uint" if name == "uintBitsToFloat" else f"float {WHOLE.get(name, '')}"
        lacking = size == 1 and name in REDUCING | {"normalize", "reflect"} or name == "cross" and size != 3  # in HLSL, Metal or C++
        if kinds - {None} and (len(kinds) > 1 or kind not in wanted.split() or others != {size} or lacking or numbers - {size} and numbers != {1}):
            self.refuse_types(node)
        kind = "float" if name == "uintBitsToFloat" else kind
        return TYPES.get((kind, 1 if size and name in REDUCING else size))


class Printer:
    """A shader's text in another language: subclasses edit the nodes, words and comments that differ."""

    words, remarks = {}, {}  # translations of names, and of words in comments

    def __init__(self, shader):
        self.shader, self.refuse, self.edits = shader, shader.refuse, []
        for node in [node for item in shader.items + shader.defined for node in item.walk()]:
            getattr(self, node.kind, lambda node: None)(node)
        for token in shader.tokens + [token for macro in shader.defined for token in macro.body]:
            if token.kind == "name":
                self.replace(token, self.word(token.text))
        for token in shader.comments:
            self.replace(token, self.remark(token.text))
        for token in shader.dialects:  # conditions that only GLSL needs
            self.replace(token, "")

    def word(self, word):
        return self.words.get(word, word)

    def remark(self, text):
        """Returns the translation of a comment."""
        return re.sub(r"\w+", lambda match: self.remarks.get(match[0], match[0]), text)

    def edit(self, start, end, text):
        """Replaces a part of the text. Of edits that overlap, the one that starts first or was made first counts."""
        self.edits.append((start, 2, len(self.edits), end, text))

    def replace(self, place, text):
        if text != self.shader.text[place.start:place.end]:
            self.edit(place.start, place.end, text)

    def before(self, place, text):
        """Inserts a text before a token or node, outside of earlier ones."""
        self.edits.append((place.start, 1, -len(self.edits), place.start, text))

    def after(self, place, text):
        """Inserts a text after a token or node, outside of earlier ones."""
        self.edits.append((place.end, 0, len(self.edits), place.end, text))

    def text(self, start=0, end=None):
        """Returns the edited text between two places."""
        end, result, place = len(self.shader.text) if end is None else end, "", start
        for first, rank, _, last, text in sorted(self.edits):
            if place <= first and last <= end and (first, rank) not in ((start, 0), (end, 1)):
                result, place = result + self.shader.text[place:first] + text, last
        return result + self.shader.text[place:end]
