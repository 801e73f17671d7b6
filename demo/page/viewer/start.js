// Makes the modules in this page importable, each after those that it imports, and starts main.js.
{
  const urls = new Map();
  const fileOf = path => path === 'three' ? 'three.module.min.js' : path.split('/').pop();

  function urlOf(file) {
    if(!urls.has(file)) {
      const element = document.querySelector(`script[data-module="${file}"]`);
      const code = element.textContent.replace(/from '([^']+)'/g,
        (_, path) => `from '${urlOf(fileOf(path))}'`);
      urls.set(file, URL.createObjectURL(new Blob([code], {type: 'text/javascript'})));
    }
    return urls.get(file);
  }

  function report(error) {
    const message = document.createElement('p');
    message.className = 'error';
    message.textContent = `This page cannot be shown: ${error.message}`;
    document.getElementById('stage').replaceChildren(message);
    console.error(error);
  }

  import(urlOf('main.js')).then(main => main.show()).catch(report);
}
