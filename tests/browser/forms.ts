// Ways in which the page of a manual contains a program.
import { escaped } from './embedded';

/** Contains characters that Markdown, HTML and templates interpret. */
export const PROGRAM = `O0001 (*EMPHASIS* _HERE_ \`AND\` [HERE](THERE))
#100=#1*2+#3*4

IF[#100 LT 5](SMALL)
(A<B & C>D &amp; &lt;)
  M98<SUB>


$1 {2} {{3}} \\ ~4~
M30`;

export type Form = 'text' | 'script' | 'pre' | 'marked script' | 'marked pre' | 'src';

/** The HTML that an author writes for this program. */
export function embed(form: Form, text: string): string {
  switch (form) {
    case 'text':
      return `<gcode-playground view="picture">\n${escaped(text)}\n</gcode-playground>`;
    case 'script':
      return `<gcode-playground view="picture"><script type="text/x-gcode">\n${text}\n</script></gcode-playground>`;
    case 'pre':
      return `<gcode-playground view="picture"><pre>\n${escaped(text)}\n</pre></gcode-playground>`;
    case 'marked script':
      return `<script type="text/x-gcode" data-gcode-playground data-view="picture">\n${text}\n</script>`;
    case 'marked pre':
      return `<pre data-gcode-playground data-view="picture">${escaped(text)}</pre>`;
    case 'src':
      return `<gcode-playground view="picture" src="data:text/plain,${encodeURIComponent(text)}"></gcode-playground>`;
  }
}
