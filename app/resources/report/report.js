const list = document.querySelector("main"), cuts = [...list.children];
const orders = {
  worst: (a, b) => a.dataset.rank - b.dataset.rank,
  name: (a, b) => a.dataset.place - b.dataset.place,
  time: (a, b) => b.dataset.seconds - a.dataset.seconds,
};
const order = document.querySelector("select");
const sort = () => list.append(...cuts.sort((a, b) => orders[order.value](a, b) || orders.name(a, b)));
order.addEventListener("change", sort);
