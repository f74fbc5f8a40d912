"""Mathematics of the site: what pandoc writes as MathML, made fit for MathML Core, which is all that Chromium knows."""
import re

UPRIGHT = re.compile(r'<mstyle mathvariant="[\w-]+">((?:<m[in]>[^<]*</m[in]>)+)</mstyle>')
NAMED_FUNCTION = re.compile(r"<mo>([a-z]{2,})</mo>")
OPENING = r'<mo stretchy="\w+" form="prefix">[^<]*</mo>'
# Parentheses around what is not higher than a line
LOW = re.compile(r'<mo stretchy="true" form="prefix">([(\[|])</mo>((?:<m[ion]>[^<]*</m[ion]>|<mi mathvariant="normal">[^<]*</mi>|<mspace[^>]*></mspace>'
                 r'|</?m(?:row|sub)>|<mo stretchy="false"[^>]*>[^<]*</mo>)*?)<mo stretchy="true" form="postfix">([)\]|])</mo>')


def with_upright_names(text):
    """Each name of several letters, \\mathrm{pdf}, as one upright identifier: MathML Core ignores <mstyle mathvariant>, so that the letters would be
    italic, a product."""
    return UPRIGHT.sub(lambda match: f'<mi mathvariant="normal">{re.sub("<[^>]+>", "", match[1])}</mi>', text)


def with_function_spaces(text):
    """Names of functions (operators to pandoc) with a thin space only where TeX has one: not first in a row, not before a parenthesis."""
    def spaced(match):
        before, after = text[:match.start()], text[match.end():]
        first = re.search(r"(?:<(?:mrow|mtd|msup|msub|munder|semantics)>|<mo[^<]*</mo>|<mspace[^>]*></mspace>)+$", before)
        argument = re.match(rf"(?:<m[ni]>[^<]*</m[ni]></msu[pb]>)?(?:<mrow>)?{OPENING}", after)
        return f'<mo lspace="{"0" if first else "0.167em"}" rspace="{"0" if argument else "0.167em"}">{match[1]}</mo>'
    return NAMED_FUNCTION.sub(spaced, text)


def with_signs(text):
    """A minus after a parenthesis or an operator as a sign."""
    return re.sub(rf"(^|<mrow>|<mtd>|{OPENING}|<mo>[=<>≤≥≈,×·]</mo>)<mo>−</mo>", r'\1<mo form="prefix">−</mo>', text)


def with_low_parentheses(text):
    """Parentheses stretch only around what is higher than a line: the stretched ones have a wide space."""
    while (changed := LOW.sub(r'<mo stretchy="false" form="prefix">\1</mo>\2<mo stretchy="false" form="postfix">\3</mo>', text)) != text:
        text = changed
    return text


def mended(body):
    """HTML with the formulas as above."""
    def formula(match):
        return with_signs(with_function_spaces(with_low_parentheses(with_upright_names(match[0]))))
    return re.sub(r"<math.*?</math>", formula, body, flags=re.DOTALL)
