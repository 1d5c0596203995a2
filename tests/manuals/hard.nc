O0002 (A<B & "C" *D* _E_ [F](G) `H` 'I' -- ...)
#100=#1*2+#3*4
# 1
IF[#100 LT 5]GOTO10

M98<SUB> &lt; &amp;amp;

    G00 X1 (</style></pre></script>)
> 1
- 2
1. 3
===
<!-- {{ y }} $${z}$ ${w} \ | ~~~ --> ]]>
```
:::note
import x from 'y'
%
N10 M30
