// Who opens index.html from a disk is told what to do instead: from there a browser loads no modules and no wasm.
// A classic script, because nothing else of the page is loaded then. The policy of the page allows no inline styles, so its style sheet is a constructed one.
function sayWhatToDo() {
  const folder = decodeURI(location.pathname)
    .replace(/[^/]*$/, '')
    .replace(/^\/(?=[A-Za-z]:)/, '');
  const start = `cd "${folder}"\npython3 -m http.server 8000 --bind 127.0.0.1`;
  const texts = {
    en: [
      'G-code playground',
      'From a disk a browser loads no part of this page. Start a server in this folder:',
      'or, with Node,',
      'Then open',
      'Without a network it works all the same: the server is on your own computer.',
    ],
    zh: [
      'G 代码演练场',
      '直接从磁盘打开时，浏览器不会加载本页面。请在此文件夹中启动一个服务器：',
      '或使用 Node：',
      '然后打开',
      '没有网络也能使用：服务器就在您自己的电脑上。',
    ],
    ru: [
      'Песочница G-кода',
      'С диска браузер эту страницу не загружает. Запустите сервер в этой папке:',
      'или, если есть Node,',
      'Затем откройте',
      'Сеть для этого не нужна: сервер работает на вашем компьютере.',
    ],
  };
  const make = (tag, text, more = {}) => Object.assign(document.createElement(tag), { textContent: text }, more);
  const said = Object.entries(texts).map(([lang, [title, why, or, then, note]]) => {
    const part = make('section', '', { lang });
    const address = 'http://127.0.0.1:8000/';
    const open = make('p', `${then} `);
    open.append(make('a', address, { href: address }), '.');
    part.append(
      make('h1', title),
      make('p', why),
      make('pre', start),
      make('p', or),
      make('pre', 'npx serve -l 8000'),
      open,
      make('p', note),
    );
    return part;
  });
  const main = document.createElement('main');
  main.append(...said);
  const styles = new CSSStyleSheet();
  styles.replaceSync(`
    body { margin: 0; font: 1rem/1.5 system-ui, sans-serif; }
    main { display: grid; gap: 1rem; max-inline-size: 44rem; margin: auto; padding: 1.5rem; }
    section + section { border-block-start: 1px solid; padding-block-start: 1rem; }
    h1 { margin: 0; font-size: 1.125rem; }
    p { margin: 0.5rem 0; }
    pre { margin: 0.5rem 0; padding: 0.6rem 0.8rem; border: 1px solid; border-radius: 6px; white-space: pre-wrap; overflow-wrap: anywhere; }
  `);
  document.adoptedStyleSheets = [styles];
  document.body.replaceChildren(main);
}

if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', sayWhatToDo);
else sayWhatToDo();
